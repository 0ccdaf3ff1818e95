#include "lessons/files/printed_by.hpp"

#include <fmt/format.h>
#include <glib.h>

#include <memory>

#include "lessons/page/error.hpp"

namespace byhand::course {

std::string printed_by(const std::string& path, const std::vector<std::string>& arguments) {
  std::vector<char*> argv = {const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  gchar* printed = nullptr;
  gint status = 0;
  GError* error = nullptr;
  if (g_spawn_sync(nullptr, argv.data(), nullptr, G_SPAWN_DEFAULT, nullptr, nullptr, &printed, nullptr, &status,
                   &error))
    g_spawn_check_wait_status(status, &error);
  const std::unique_ptr<gchar, decltype(&g_free)> text(printed, g_free);
  if (error) {
    const std::unique_ptr<GError, decltype(&g_error_free)> owned(error, g_error_free);
    throw EnvironmentError(fmt::format("{} failed: {}.", path, owned->message));
  }
  return text.get();
}

}  // namespace byhand::course
