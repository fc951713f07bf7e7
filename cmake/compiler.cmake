# What every target is compiled with. Fused multiply-add would make results depend on the processor,
# so contraction is off for the whole program.
add_library(stream_recon_flags INTERFACE)
target_compile_options(stream_recon_flags INTERFACE
  -ffp-contract=off -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
set(STREAM_RECON_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined")
if(STREAM_RECON_SANITIZE)
  add_compile_options(-fsanitize=${STREAM_RECON_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${STREAM_RECON_SANITIZE})
endif()
