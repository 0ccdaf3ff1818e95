// A lesson's frame, a scene beside two charts at 1280 × 720: how long it takes to draw, to encode, and both with
// the file written. The goal is 40 frames a second on two cores.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "renderer/frames.hpp"
#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/png.hpp"
#include "tests/renderer/scenes.hpp"

namespace byhand::renderer {
namespace {

constexpr int width = 1280, height = 720;

Image frame(PixelCanvas& canvas, int index) {
  canvas.clear();
  scenes::lesson_frame(canvas, 0.7 * std::sin(0.05 * index));
  return canvas.image();
}

void draw(benchmark::State& state) {
  PixelCanvas canvas(width, height);
  int index = 0;
  for (auto _ : state) benchmark::DoNotOptimize(frame(canvas, index++));
}
BENCHMARK(draw)->Unit(benchmark::kMillisecond)->UseRealTime();

void encode(benchmark::State& state) {
  PixelCanvas canvas(width, height);
  const Image image = frame(canvas, 0);
  for (auto _ : state) benchmark::DoNotOptimize(encode_png(image));
  state.counters["bytes"] = double(encode_png(image).size());
}
BENCHMARK(encode)->Unit(benchmark::kMillisecond)->UseRealTime();

void frames_to_disk(benchmark::State& state) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("byhand_frames_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  PixelCanvas canvas(width, height);
  FrameEncoder encoder([&](int index, std::string_view png) {
    std::ofstream(folder / (std::to_string(index) + ".png"), std::ios::binary) << png;
  });
  int index = 0;
  for (auto _ : state) encoder.add(frame(canvas, index++));
  encoder.finish();
  state.counters["frames/s"] = benchmark::Counter(double(index), benchmark::Counter::kIsRate);
  std::filesystem::remove_all(folder);
}
BENCHMARK(frames_to_disk)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace byhand::renderer
