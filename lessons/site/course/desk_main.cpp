// Writes the page of the derivation desk alone, desk.html: page_desk FOLDER.

#include "lessons/desk/task_files.hpp"
#include "lessons/files/atomic_file.hpp"
#include "lessons/site/course/desk_page.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  byhand::course::write_whole(std::filesystem::path(argv[1]) / "desk.html",
                              byhand::site::desk_page(byhand::desk::read_tasks(BYHAND_DESK_TASKS)));
  return 0;
}
