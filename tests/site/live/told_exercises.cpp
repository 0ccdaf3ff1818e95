// What the terminal's judge says of each solution and mutant of the exercises, a line of JSON each: the judge in
// the page is compared with it.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "lessons/practise/judge/compiled.hpp"
#include "lessons/practise/judge/judge.hpp"

int main() {
  using namespace byhand::practise;
  for (const Exercise& exercise : exercises()) {
    const Key answers = key(exercise, 1);
    for (const Variant& variant : exercise.variants) {
      Verdict verdict = judge(exercise, answers, variant.code);
      finish(verdict, "");
      nlohmann::json told = {{"exercise", exercise.name},
                             {"file", variant.file},
                             {"sentence", verdict.sentence},
                             {"details", verdict.details}};
      const Film& film = verdict.film;
      for (const Frame& frame : film.frames) told["film"].push_back(numbers_of(frame));
      if (!film.frames.empty()) told["tolerance"] = film_tolerance(exercise, variant.code, film);
      std::puts(told.dump().c_str());
    }
  }
}
