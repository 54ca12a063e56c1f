# -fsanitize= for everything, when AJAR_SANITIZE names any.
if(AJAR_SANITIZE)
  add_compile_options(-fsanitize=${AJAR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${AJAR_SANITIZE})
endif()
