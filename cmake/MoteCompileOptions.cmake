# Warnings, sanitizers and the flags that every target of this project shares.

add_library(MoteCompileOptions INTERFACE)
target_compile_options(MoteCompileOptions INTERFACE -Wall -Wextra -Wno-unused-parameter)
if (MOTE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer
    -fno-sanitize-recover=undefined)
  # The vptr check wants the type information of classes in VTK's own libraries.
  add_compile_options(-fno-sanitize=vptr)
  add_link_options(-fsanitize=address,undefined)
  if (MOTE_FUZZ)
    # VTK's libraries are built without it, and calls into them would count as wrong ones.
    add_compile_options(-fsanitize=fuzzer-no-link -fno-sanitize=function)
  endif ()
endif ()
if (MOTE_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_compile_definitions(MOTE_COVERAGE)
  add_link_options(--coverage)
endif ()
if (MOTE_SANITIZE_THREADS)
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
endif ()
