// After step 6: engines that exist in WebAssembly alone, beside this course in WebAssembly.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"

namespace byhand::beside {

void in_webassembly(const Setting& setting, Page& page) {
  const auto& all = engines::engines_in_webassembly();
  page.text(
      R"(PhysX, Jolt, Rapier and a later MuJoCo come from npm, compiled to WebAssembly. Node runs them, and beside them this course, compiled
      to WebAssembly as well. Rapier's multibody joints are not tried.)");
  std::string names;
  for (const std::string& name : engines::missing_in_webassembly()) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    page.text(
        R"(Not here: @. `./lessons/run 10` fetches the engines and compiles this course if it finds node, npm and the packages
        that `./lessons/run site` installs.)",
        names);
  if (all.empty()) return;
  page.text(
      R"(WebAssembly is slower than native code, and not by the same factor for every engine. So the times of this step
      are compared with one another only; this course has the same errors in both. Settings of up to @ iterations a frame are tried for the chain, of @ for the pyramid.)",
      most_of_joints_in_webassembly, most_of_contacts_in_webassembly);
  std::vector<std::vector<std::string>> rows;
  for (const Engine& engine : all)
    rows.push_back({engine.name, engine.version, engine.single ? "single" : "double", with_build(engine),
                    engine.file.substr(engine.file.rfind('/') + 1)});
  page.table({"engine", "version", "precision", "how it solves", "its settings"}, rows);
  if (const auto out = left_out(setting, Party::webassembly); !out.empty()) page.table(head_of_left_out, out);
  chain_in_webassembly(setting, page);
  wall_in_webassembly(setting, page);
}

}  // namespace byhand::beside
