// Writes the page of the exercises, practise.html: page_practise FOLDER.

#include "lessons/files/atomic_file.hpp"
#include "lessons/practise/page/practise_page.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  byhand::course::write_whole(std::filesystem::path(argv[1]) / "practise.html", byhand::practise::practise_page());
  return 0;
}
