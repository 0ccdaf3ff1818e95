#include "lessons/terminal/desktop.hpp"

#include <fcntl.h>
#include <glib.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace byhand::course {

std::string open_in_viewer(const std::string& path) {
  const std::unique_ptr<char, decltype(&g_free)> viewer(g_find_program_in_path("xdg-open"), g_free);
  if (!viewer) return "There is no xdg-open here (Debian package xdg-utils).";
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return "There is no desktop here.";
  // It must outlive the lesson, and neither read its keys nor write on its screen.
  const char* arguments[] = {viewer.get(), path.c_str(), nullptr};
  const auto detach = [](void*) { setsid(); };
  GError* error = nullptr;
  g_spawn_async(nullptr, const_cast<char**>(arguments), nullptr,
                static_cast<GSpawnFlags>(G_SPAWN_STDOUT_TO_DEV_NULL | G_SPAWN_STDERR_TO_DEV_NULL), detach, nullptr,
                nullptr, &error);
  if (!error) return "";
  const std::string why = error->message;
  g_error_free(error);
  return why + ".";
}

}  // namespace byhand::course
