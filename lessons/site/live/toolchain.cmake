# C++20 to WebAssembly by Debian's clang-19, lld-19, wasi-libc and libc++-19-dev-wasm32.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR /usr/bin/ar)
set(CMAKE_RANLIB /usr/bin/ranlib)
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -D_WASI_EMULATED_SIGNAL")
# -O0 keeps Binaryen away, which where it is installed takes ten times as long to save a hundredth, and changes the
# bytes; with --no-wasm-opt clang 19 does not link at all.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-O0 -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=1048576 -lwasi-emulated-signal")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
