# Inline functions and templates, Eigen's among them, are compiled into the library and into a program that uses them,
# perhaps with other settings or for another processor. Both have the same name, and the linker keeps one: the program's,
# which could add in another order or fuse. So the library's objects call theirs by names of their own, and offer them
# under the shared names as well, among which is the library's interface.
#
#   cmake -Dobjects=a.o;b.o… -Darchive=lib.a -Dobjdump=… -Dobjcopy=… -Dar=… -Dfolder=… -P own_names.cmake
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
list(FILTER objects INCLUDE REGEX "\\.o$")  # not a precompiled header
set(renamed)
foreach(object IN LISTS objects)
  list(LENGTH renamed number)
  set(copy ${folder}/${number}.o)
  execute_process(COMMAND ${objdump} --syms ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  # value, w, F (a weak function), section, size, perhaps .hidden, name
  string(REGEX MATCHALL "[0-9a-f]+  w    F [^\t\n]+\t[0-9a-f]+ [^\n]+" weak "${symbols}")
  set(names)
  set(shared)
  foreach(line IN LISTS weak)
    string(REGEX MATCH "^([0-9a-f]+)  w    F ([^\t]+)\t[0-9a-f]+ (\\.hidden )?(.+)$" line "${line}")
    string(APPEND names "${CMAKE_MATCH_4} ${CMAKE_MATCH_4}.byhand\n")
    string(APPEND shared "--add-symbol=${CMAKE_MATCH_4}=${CMAKE_MATCH_2}:0x${CMAKE_MATCH_1},weak,function\n")
  endforeach()
  # A constructor's code is shared under the name of a group.
  string(REGEX MATCHALL "l       \\.group\t[0-9a-f]+ [^\n]+" groups "${symbols}")
  foreach(line IN LISTS groups)
    string(REGEX REPLACE ".* " "" name "${line}")
    string(APPEND names "${name} ${name}.byhand\n")
  endforeach()
  file(WRITE ${copy}.names "${names}")
  file(WRITE ${copy}.shared "${shared}")
  execute_process(COMMAND ${objcopy} --redefine-syms=${copy}.names ${object} ${copy} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${objcopy} @${copy}.shared ${copy} COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND renamed ${copy})
endforeach()
file(REMOVE ${archive})
execute_process(COMMAND ${ar} rcs ${archive} ${renamed} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${folder})
