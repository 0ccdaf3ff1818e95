# The sources of all exercises: of the judge here and of the one in a page.
set(practise_folder ${CMAKE_CURRENT_LIST_DIR})

# The code of one file of an exercise, in a namespace of its own.
function(practise_variant name file out)
  string(MAKE_C_IDENTIFIER "e${name}_${file}" space)
  set(${out} "namespace ${space} {
#include \"lessons/practise/${name}/${file}\"
Numbers run(std::size_t which, const Numbers& in) { return answer(which, in, FUNCTIONS); }
}
" PARENT_SCOPE)
  set(${out}_entry "{\"${file}\", &${space}::run}, " PARENT_SCOPE)
endfunction()

# An exercise is a folder 01_name/ with task.md, signature.hpp, probe.cpp, stub.cpp, solution.cpp and mutants/*.cpp.
# What a course gets has neither the solution nor the mutants. Sets `names` and the variable `sources`.
function(practise_exercises names sources)
  set(declared)
  set(all)
  set(made)
  set(found)
  file(GLOB folders CONFIGURE_DEPENDS ${practise_folder}/[0-9][0-9]_*)
  foreach(folder IN LISTS folders)
    get_filename_component(name ${folder} NAME)
    set(space e${name})
    set(variants)
    set(listed)
    file(GLOB files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/solution.cpp ${folder}/mutants/*.cpp)
    list(REMOVE_ITEM files solution.cpp)
    if(EXISTS ${folder}/solution.cpp)
      list(PREPEND files solution.cpp)
    endif()
    foreach(file IN LISTS files)
      practise_variant(${name} ${file} text)
      string(APPEND variants "${text}")
      string(APPEND listed "${text_entry}")
    endforeach()
    configure_file(${practise_folder}/exercise.cpp.in ${name}.cpp @ONLY)
    list(APPEND made ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    list(APPEND found ${name})
    string(APPEND declared "extern const Exercise ${space}_exercise;\n")
    string(APPEND all "${space}_exercise, ")
  endforeach()
  file(CONFIGURE OUTPUT exercises.cpp @ONLY CONTENT "// Made by the build.
#include \"lessons/practise/judge/exercise.hpp\"
namespace byhand::practise {
@declared@
const std::vector<Exercise>& exercises() {
  static const std::vector<Exercise> all = {@all@};
  return all;
}
}
")
  set(${names} ${found} PARENT_SCOPE)
  set(${sources} ${made} ${CMAKE_CURRENT_BINARY_DIR}/exercises.cpp PARENT_SCOPE)
endfunction()
