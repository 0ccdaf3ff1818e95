// The program behind ./lessons/run site, with a course of one small lesson.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/checksum.hpp"
#include "lessons/laws/law.hpp"
#include "lessons/site/course/course_pages.hpp"
#include "lessons/site/course/site_folder.hpp"
#include "lessons/site/course/slides.hpp"
#include "lessons/site/frame.hpp"
#include "renderer/error.hpp"
#include "tests/lessons/terminal/process.hpp"
#include "tests/site/markup.hpp"

namespace byhand::tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string program = std::string(BYHAND_SITE_OF_FIXTURE) + " --without-slides";

/// The site of the fixture, written once.
class Site : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Folder>();
    const Finished finished = run(fmt::format("{} --output {}", program, folder_->path().string()));
    ASSERT_EQ(finished.status, 0) << finished.complained;
    for (const auto& entry : fs::directory_iterator(root()))
      if (entry.path().extension() == ".html")
        pages_.emplace(entry.path().filename(), of_page(contents(entry.path())));
  }
  static void TearDownTestSuite() {
    pages_.clear();
    folder_.reset();
  }
  static fs::path root() { return folder_->path() / "site"; }

  static std::unique_ptr<Folder> folder_;
  static std::map<std::string, Markup> pages_;
};
std::unique_ptr<Folder> Site::folder_;
std::map<std::string, Markup> Site::pages_;

std::string without_version(const std::string& link) { return link.substr(0, link.find("?v=")); }

TEST_F(Site, HasItsPages) {
  std::vector<std::string> names;
  for (const auto& page : pages_) names.push_back(page.first);
  EXPECT_THAT(names, ElementsAre("99_fixture.html", "answers.html", "equations.html", "index.html", "laws.html",
                                 "playground.html", "teaching.html"));
}

TEST_F(Site, ThePlaygroundSaysWhatItNeeds) {
  // The fixture's site has no WebAssembly.
  EXPECT_THAT(pages_.at("playground.html").all("//main//p[@class='summary']"),
              ElementsAre(HasSubstr("written without the compiler")));
  EXPECT_THAT(pages_.at("playground.html").all("//main//button"), IsEmpty());
}

TEST(Frames, LeadToTheExercisesOfASiteThatHasThem) {
  const auto links = [](const site::Frame& frame) {
    return of_page(site::framed(frame)).all("//nav[@aria-label='Course']//a[@href='practise.html']");
  };
  EXPECT_THAT(links({.title = "Laws", .content = ""}), IsEmpty());
  EXPECT_THAT(links({.title = "Laws", .content = "", .exercises = true}), ElementsAre("Exercises"));
}

TEST_F(Site, ALessonHasPicturesForANarrowPageInAFileOfTheirOwn) {
  const Markup& page = pages_.at("99_fixture.html");
  const std::vector<std::string> files = page.all("/*/@data-narrow");
  ASSERT_EQ(files.size(), 1U);
  EXPECT_THAT(contents(root() / without_version(files[0])), testing::StartsWith("'use strict';\nbyhandNarrow('"));
  EXPECT_FALSE(fs::exists(root() / "99_fixture" / "narrow.json"));
  // Their ratio keeps the room for them.
  EXPECT_THAT(page.all("//*[@class='picture']//*[local-name()='svg']/@width"),
              testing::AllOf(testing::Not(IsEmpty()), testing::Each("490")));
}

TEST_F(Site, EveryPageIsWellFormed) {
  for (const auto& [name, page] : pages_) EXPECT_EQ(page.mistake(), "") << name;
}

TEST_F(Site, EveryLinkAndAnchorResolves) {
  int links = 0;
  for (const auto& [name, page] : pages_)
    for (const std::string& link : page.all("//@href | //@src")) {
      if (link.starts_with("data:")) continue;
      if (link.starts_with("https://")) continue;
      const auto hash = link.find('#');
      const std::string file = link.substr(0, std::min(hash, link.find('?')));
      EXPECT_TRUE(file.empty() || fs::is_regular_file(root() / file)) << name << ": " << link;
      if (hash == std::string::npos) continue;
      const Markup& target = pages_.at(file.empty() ? name : file);
      const std::string id = link.substr(hash + 1);
      EXPECT_EQ(target.all(fmt::format("//*[@id='{}']", id)).size(), 1U) << name << ": " << link;
      ++links;
    }
  EXPECT_GT(links, 20);
}

TEST_F(Site, StylesNameFilesThatAreThere) {
  const std::string css = contents(root() / "assets" / "style.css");
  const std::regex url("url\\(([^)]*)\\)");
  int files = 0;
  for (std::sregex_iterator it(css.begin(), css.end(), url), end; it != end; ++it, ++files)
    EXPECT_TRUE(fs::is_regular_file(root() / "assets" / without_version((*it)[1].str()))) << (*it)[1];
  EXPECT_GT(files, 5);
  EXPECT_TRUE(fs::is_regular_file(root() / "assets" / "fonts" / "LICENCES.txt"));
}

TEST_F(Site, AsksNothingOfOtherHosts) {
  for (const auto& [name, page] : pages_)
    for (const std::string& link : page.all("//link/@href | //@src"))
      EXPECT_EQ(link.find("//"), std::string::npos) << name << ": " << link;
  for (const char* const file : {"style.css", "site.js"})
    EXPECT_EQ(contents(root() / "assets" / file).find("://"), std::string::npos) << file;
}

TEST_F(Site, ScriptsAndStylesCarryTheirChecksums) {
  int files = 0;
  for (const auto& [name, page] : pages_)
    for (const std::string& link : page.all("//script/@src | //link[@rel='stylesheet']/@href | //@data-index")) {
      const std::string file = without_version(link);
      EXPECT_EQ(link, file + "?v=" + course::sha256(contents(root() / file)).substr(0, 8)) << name;
      ++files;
    }
  EXPECT_GT(files, 15);
}

TEST_F(Site, ALessonHasAPictureForTheListAndOneForPreviews) {
  EXPECT_THAT(contents(root() / "99_fixture/card.svg"), testing::Not(HasSubstr("<text")));
  EXPECT_EQ(contents(root() / "99_fixture/card.png").substr(1, 3), "PNG");
  EXPECT_THAT(pages_.at("99_fixture.html").all("//meta[@property='og:image']/@content"),
              ElementsAre("99_fixture/card.png"));
  EXPECT_THAT(pages_.at("index.html").all("//section[@class='card']/img/@src"),
              ElementsAre("99_fixture/card.svg"));
}

TEST_F(Site, TheKeyAnswersEveryQuestionAndCanBeLeftOut) {
  const auto questions = pages_.at("99_fixture.html").all("//form/@data-question");
  EXPECT_EQ(pages_.at("answers.html").all("//section/section[h3]").size(), questions.size());
  EXPECT_THAT(pages_.at("answers.html").all("//section/section[not(p/strong='Answer')]"), IsEmpty());
  const Folder without;
  ASSERT_EQ(run(fmt::format("{} --quiet --without-answers --output {}", program, without.path().string())).status,
            0);
  EXPECT_FALSE(fs::exists(without / "site" / "answers.html"));
}

TEST_F(Site, TheFiguresOfALessonCanBeTakenAlong) {
  const Folder folder;
  ASSERT_EQ(run(fmt::format("cd {} && /usr/bin/python3 -m zipfile -e {} .", folder.path().string(),
                            (root() / "downloads/99_fixture_figures.zip").string()))
                .status,
            0);
  EXPECT_EQ(of_page(contents(folder / "figure-errors.svg")).mistake(), "");
  // All pictures of the film, which follow one another.
  const Markup film = of_page(contents(folder / "film-settling.svg"));
  EXPECT_EQ(film.mistake(), "");
  const auto begins = film.all("/svg/svg/@style");
  ASSERT_GT(begins.size(), 2U);
  EXPECT_NE(film.all("/svg/svg[1]/*//@*"), film.all("/svg/svg[last()]/*//@*"));
  EXPECT_EQ(begins[1], "animation-delay:0.333s");
  EXPECT_EQ(contents(folder / "errors.csv"), contents(root() / "99_fixture/data/errors.csv"));
}

TEST_F(Site, TeachersAreOfferedWhatThereIsToDownload) {
  const std::vector<site::Digest> lessons{{.slug = "99_fixture", .steps = {{.label = "1"}}}};
  const Folder there;
  for (const char* const file : {"slides/99_fixture.html", "downloads/exercises.zip"})
    course::write_whole(there / file, "it");
  EXPECT_THAT(of_page(site::teaching_page(lessons, {}, there.path())).all("//section[@id='downloads']//a/@href"),
              ElementsAre("downloads/exercises.zip", "slides/99_fixture.html"));
  EXPECT_THAT(pages_.at("teaching.html").all("//section[@id='downloads']//a/@href"),
              ElementsAre("answers.html", "constraints_by_hand.epub", "downloads/99_fixture_figures.zip"));
}

TEST_F(Site, OnlyLessonsThatThereAreCanBeChosen) {
  const Folder folder;
  EXPECT_EQ(run(fmt::format("{} --quiet --lesson 98_none --output {}", program, folder.path().string())).status,
            2);
  ASSERT_EQ(run(fmt::format("{} --quiet --lesson 99_fixture --output {}", program, folder.path().string())).status,
            0);
  EXPECT_TRUE(fs::exists(folder / "site" / "99_fixture.html"));
}

TEST_F(Site, TheLawsAreOneTableWithAFormulaEach) {
  const Markup& laws = pages_.at("laws.html");
  const auto rows = laws::all();
  EXPECT_EQ(laws.all("//table[@class='all-laws']/tbody/tr").size(), rows.size());
  EXPECT_EQ(laws.all("//table[@class='all-laws']//td[@class='formula'][normalize-space()!='']").size(),
            rows.size());
  EXPECT_THAT(laws.all("//tr[@id='law-17']/td[2]"), ElementsAre(HasSubstr("N³ <")));
}

TEST_F(Site, TheBookHasAStyleSheetOfItsOwnInWhichFiguresFit) {
  const Folder folder;
  ASSERT_EQ(run(fmt::format("cd {} && /usr/bin/python3 -m zipfile -e {} .", folder.path().string(),
                            (root() / "constraints_by_hand.epub").string()))
                .status,
            0);
  EXPECT_FALSE(fs::exists(folder / "book/assets/style.css"));
  const std::string css = contents(folder / "book/assets/book.css");
  EXPECT_THAT(css, HasSubstr(".picture svg, .picture img { display: block; width: 100%; max-width: 100%;"));
  EXPECT_THAT(css, testing::Not(HasSubstr("min-width")));
}

TEST_F(Site, TheBooksQuestionsHaveTheirAnswersAtTheEndOfTheChapter) {
  const Folder folder;
  ASSERT_EQ(run(fmt::format("cd {} && /usr/bin/python3 -m zipfile -e {} .", folder.path().string(),
                            (root() / "constraints_by_hand.epub").string()))
                .status,
            0);
  const Markup chapter = of_page(contents(folder / "book/99_fixture.xhtml"));
  EXPECT_EQ(chapter.mistake(), "");
  EXPECT_THAT(chapter.all("//form//details"), IsEmpty());
  const auto questions = chapter.all("//form[@class='question']/@data-question");
  EXPECT_THAT(questions, testing::Not(IsEmpty()));
  for (const std::string& question : questions) {
    EXPECT_EQ(chapter.all(fmt::format("//form//a[@href='#answer-{}']", question)).size(), 1U) << question;
    EXPECT_EQ(chapter.all(fmt::format("//section[@class='answers']/section[@id='answer-{}']", question)).size(),
              1U)
        << question;
  }
  EXPECT_THAT(chapter.all("//section[@id='to-try'] | //table[ancestor::details[@class='parameters']]"), IsEmpty());
  EXPECT_THAT(contents(folder / "book/package.opf"), HasSubstr("<dc:creator>"));
}

TEST_F(Site, EveryPageHasLandmarksATitleAndOneMainHeading) {
  for (const auto& [name, page] : pages_) {
    EXPECT_EQ(page.all("/html/@lang").size(), 1U) << name;
    EXPECT_THAT(page.all("/html/head/title"), ElementsAre(HasSubstr("Constraints by Hand"))) << name;
    for (const char* const one :
         {"//main", "//h1", "/html/body/header", "/html/body/footer", "/html/body/a[@class='skip']"})
      EXPECT_EQ(page.all(one).size(), 1U) << name << ": " << one;
    EXPECT_THAT(page.all("//nav[not(@aria-label)]"), IsEmpty()) << name;
    EXPECT_EQ(page.all("//body/a[@class='skip']/@href").front(), "#content") << name;
  }
}

TEST_F(Site, HeadingsSkipNoLevel) {
  for (const auto& [name, page] : pages_) {
    EXPECT_THAT(page.all("//h3[not(preceding::h2)]"), IsEmpty()) << name;
    EXPECT_THAT(page.all("//h4"), IsEmpty()) << name;
    EXPECT_THAT(page.all("//h2[normalize-space()='']"), IsEmpty()) << name;
  }
}

TEST_F(Site, EveryPictureHasAnAlternative) {
  for (const auto& [name, page] : pages_) {
    EXPECT_THAT(page.all("//img[not(@alt)]"), IsEmpty()) << name;
    EXPECT_THAT(page.all("(//svg | //img[not(parent::section[@class='card'])])"
                         "[not(ancestor::div[@role='img'][string-length(@aria-label) > 5])]"),
                IsEmpty())
        << name;
  }
}

TEST_F(Site, IdsAreUnique) {
  for (const auto& [name, page] : pages_) {
    const std::vector<std::string> ids = page.all("//@id");
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << name;
  }
}

TEST_F(Site, DrawsEveryFigureAndLinksItsData) {
  const Markup& lesson = pages_.at("99_fixture.html");
  EXPECT_THAT(lesson.all("//figure[@data-figure='errors']//svg"), testing::SizeIs(1));
  EXPECT_THAT(contents(root() / lesson.all("//figure[@data-figure='errors']//a[.='CSV']/@href").front()),
              HasSubstr("step (1)"));
}

TEST_F(Site, TellsScriptsTheParametersAndWhichStepReadsThem) {
  const std::string json = pages_.at("99_fixture.html").all("//script[@id='parameters']").front();
  EXPECT_THAT(json, HasSubstr(R"({"name":"beta","unit":"1")"));
  EXPECT_THAT(json, HasSubstr(R"("1":["beta","h","steps")"));
}

TEST_F(Site, APageThatIsNotLiveSaysWhy) {
  EXPECT_THAT(contents(root() / "99_fixture.html"),
              HasSubstr("This page has no sliders: its program was not compiled for a browser."));
}

TEST_F(Site, SearchKnowsTheWordsOfEveryStep) {
  const Finished unpacked = run(fmt::format(
      R"py(/usr/bin/python3 -c "import re, base64, zlib; script = open('{}').read(); \
print(zlib.decompress(base64.b64decode(re.search('byhandSearch..(.*)..;', script)[1]), -15).decode())")py",
      (root() / "assets" / "search.js").string()));
  const std::string& index = unpacked.said;
  const Markup& lesson = pages_.at("99_fixture.html");
  for (const std::string& id : lesson.all("//section/@id[starts-with(., 'step-')]"))
    EXPECT_THAT(index, HasSubstr('"' + id + '"'));
  EXPECT_THAT(index, HasSubstr("Each step of 1/60 s removes a share of the error, beta = 0.2."));
}

TEST_F(Site, RebuiltHasTheSameBytes) {
  const Folder again;
  ASSERT_EQ(run(fmt::format("{} --quiet --output {}", program, again.path().string())).status, 0);
  auto first = site::checksums(root()), second = site::checksums(again / "site");
  const auto is_clocked = [](const auto& file) {
    return file.first.find("/clock.") != std::string::npos ||
           file.first.find("/clock-narrow.") != std::string::npos;
  };
  std::erase_if(first, is_clocked);
  std::erase_if(second, is_clocked);
  EXPECT_GT(first.size(), 20U);
  EXPECT_EQ(first, second);
}

TEST_F(Site, ReplacesAnOlderSiteAndLeavesNothingBeside) {
  const Folder folder;
  fs::create_directory(folder / "site");
  std::ofstream(folder / "site" / "manifest.json") << R"({"site": "", "files": {"old.html": ""}})";
  std::ofstream(folder / "site" / "old.html") << "old";
  ASSERT_EQ(run(fmt::format("{} --quiet --output {}", program, folder.path().string())).status, 0);
  EXPECT_FALSE(fs::exists(folder / "site" / "old.html"));
  EXPECT_TRUE(fs::exists(folder / "site" / "index.html"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST_F(Site, KeepsWhatAPersonAddedToAnOlderSite) {
  const Folder folder;
  const fs::path mine = folder / "site";
  const auto write_site = [&] {
    return run(fmt::format("{} --quiet --output {}", program, folder.path().string()));
  };
  ASSERT_EQ(write_site().status, 0);
  std::ofstream(mine / "CNAME") << "example.org";
  std::ofstream(mine / "assets/mine.css") << "mine";
  fs::create_directories(mine / "thesis/old");
  std::ofstream(mine / "thesis/old/thesis.txt") << "precious";
  fs::create_symlink("thesis", mine / "link");
  for (int again = 0; again < 2; ++again) {
    ASSERT_EQ(write_site().status, 0);
    EXPECT_EQ(contents(mine / "CNAME"), "example.org");
    EXPECT_EQ(contents(mine / "assets/mine.css"), "mine");
    EXPECT_EQ(contents(mine / "thesis/old/thesis.txt"), "precious");
    EXPECT_EQ(fs::read_symlink(mine / "link"), "thesis");
    EXPECT_THAT(contents(mine / "manifest.json"), testing::Not(HasSubstr("CNAME")));
  }
}

TEST_F(Site, BookIsSoundEpub) {
  const fs::path book = root() / "constraints_by_hand.epub";
  // (epubcheck itself needs binfmt-misc to start.)
  const auto check = "java -jar /usr/share/java/epubcheck.jar";
  EXPECT_EQ(contents(book).substr(30, 28), "mimetypeapplication/epub+zip");
  if (!fs::exists("/usr/share/java/epubcheck.jar")) GTEST_SKIP() << "epubcheck is not installed";
  const Finished checked = run(check + (" " + book.string()));
  EXPECT_EQ(checked.status, 0) << checked.said << checked.complained;
  EXPECT_THAT(checked.said + checked.complained, testing::Not(HasSubstr("WARNING")));
}

TEST_F(Site, SlidesShowEveryFormulaPictureAndQuestionOnceWithTheTextAsNotes) {
  const site::Digest fixture{.slug = "99_fixture"};
  const Markup deck = of_page(site::slides(root(), fixture));
  const Markup& lesson = pages_.at("99_fixture.html");
  EXPECT_EQ(deck.mistake(), "");
  for (const char* const path :
       {"//figure[@data-figure]", "//figure[@data-film]", "//form", "//div[@class='equations']"})
    EXPECT_EQ(deck.all(path).size(), lesson.all(path).size()) << path;
  EXPECT_THAT(deck.all("//figure[@class='excerpt']//code"), testing::Not(IsEmpty()));
  EXPECT_EQ(deck.all("//aside[@class='notes']//div[@class='text']"), lesson.all("//div[@class='text']"));
  EXPECT_THAT(deck.all("//section[count(*[not(self::aside) and not(self::h3)]) > 1][not(section)][not(h1)]"),
              IsEmpty());
  for (const std::string& link : deck.all("//@href | //img/@src")) {
    if (link.starts_with("reveal/")) continue;
    EXPECT_TRUE(fs::exists(root() / link.substr(3, link.find('#') - 3))) << link;
  }
}

TEST(SiteProgram, RefusesAFolderThatItDidNotWrite) {
  const Folder folder;
  fs::create_directory(folder / "site");
  std::ofstream(folder / "site" / "thesis.html") << "mine";
  const Finished finished = run(fmt::format("{} --output {}", program, folder.path().string()));
  EXPECT_EQ(finished.status, 2);
  EXPECT_THAT(finished.complained, HasSubstr("is not a site that ./lessons/run site wrote"));
  EXPECT_EQ(contents(folder / "site" / "thesis.html"), "mine");
}

TEST(SiteProgram, RefusesBadUsageInOneSentence) {
  for (const char* const bad : {"--output", "--quality", "--nonsense", "04", "--output ''", "--output --quiet",
                                "--output -x", "\"$(printf '\\033[31m')\"", "\"$(printf 'a\\nb')\""}) {
    const Finished finished = run(program + " " + bad);
    EXPECT_EQ(finished.status, 2) << bad;
    EXPECT_EQ(finished.said, "") << bad;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
    EXPECT_THAT(finished.complained, testing::Not(HasSubstr("\033")));
  }
  EXPECT_FALSE(fs::exists("--quiet"));
}

TEST(SiteProgram, FailuresOfTheEnvironmentAreOneSentence) {
  const Folder folder;
  fs::create_symlink("circle", folder / "circle");
  fs::create_symlink("nowhere", folder / "dangling");
  for (const std::string& line :
       {std::string("--help >/dev/full"), std::string("--help >&-"), "--output " + (folder / "circle").string(),
        "--output " + (folder / "dangling").string()}) {
    const Finished finished = run(program + " " + line);
    EXPECT_EQ(finished.status, 3) << line;
    EXPECT_EQ(std::count(finished.complained.begin(), finished.complained.end(), '\n'), 1) << finished.complained;
    EXPECT_THAT(finished.complained, testing::Not(HasSubstr("filesystem error")));
    EXPECT_THAT(finished.complained, testing::ContainsRegex("standard output|is a link to")) << line;
  }
}

TEST(SiteProgram, SaysWhereItCannotWrite) {
  const Finished finished = run(program + " --output /proc/nowhere");
  EXPECT_EQ(finished.status, 3);
  EXPECT_THAT(finished.complained, HasSubstr("/proc/nowhere"));
}

TEST(SiteFolder, LeavesTheOldSiteUntilItIsFinished) {
  const Folder folder;
  fs::create_directory(folder / "site");
  {
    site::SiteFolder begun(folder / "site");
    std::ofstream(begun.path() / "index.html") << "new";
    EXPECT_TRUE(fs::is_empty(folder / "site"));
  }
  EXPECT_TRUE(fs::is_empty(folder / "site"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  site::SiteFolder finished(folder / "site");
  std::ofstream(finished.path() / "index.html") << "new";
  finished.finish();
  EXPECT_EQ(contents(folder / "site" / "index.html"), "new");
}

TEST(SiteFolder, BelongsToOneRunAtATime) {
  const Folder folder;
  const site::SiteFolder first(folder / "site");
  EXPECT_THROW(site::SiteFolder(folder / "site"), course::EnvironmentError);
}

TEST(SiteFolder, IsEmptiedOfWhatAKilledRunLeft) {
  const Folder folder;
  fs::create_directories(folder / ".site.part" / "assets");
  const site::SiteFolder fresh(folder / "site");
  EXPECT_TRUE(fs::is_empty(fresh.path()));
}

}  // namespace
}  // namespace byhand::tests
