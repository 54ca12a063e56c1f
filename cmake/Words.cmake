# Writes the SPIR-V module MODULE to the file WORDS as numbers for a C++ array.
file(READ ${MODULE} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE ${WORDS} "${words}")
