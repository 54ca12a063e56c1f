# Compiles shaders/kernels/*.comp to SPIR-V and embeds them.
