# Installs the project beside its build and builds the programs of this folder against it, out of the tree. However a
# program is compiled, built-in kinds give the same bits.
set(work ${build}/consumer)
file(REMOVE_RECURSE ${work})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -G ${generator} -S ${source} -B ${work}/build -DCMAKE_BUILD_TYPE=Release
                        -DCMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags}" -DCMAKE_PREFIX_PATH=${work}/prefix
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${work}/build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${work}/build/consumer COMMAND_ERROR_IS_FATAL ANY)
foreach(program alike native called aligned unaligned)
  execute_process(COMMAND ${work}/build/bits_${program} OUTPUT_VARIABLE ${program} COMMAND_ERROR_IS_FATAL ANY)
  if(NOT "${${program}}" STREQUAL "${alike}")
    message(FATAL_ERROR "Other bits for a program that is compiled as ${program}:\n${${program}}${alike}")
  endif()
endforeach()
