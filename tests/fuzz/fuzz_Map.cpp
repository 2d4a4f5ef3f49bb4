#include <cstddef>
#include <cstdint>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

#include "sim2d/map/MapReader.h"
#include "tests/fuzz/Require.h"

/// Any bytes as the description of a map, a line of `---`, and its image.
namespace {

constexpr const char* kBorder = "---\n";

/// The bytes as a file that exists in memory alone.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : file_(memfd_create("image", 0)) {
    require(file_ >= 0 &&
                write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "there is room for the image");
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::size_t border = all.find(kBorder);
  const base::Result<sim2d::MapDescription> description =
      sim2d::parseMapDescription(all.substr(0, border), "fuzz.yaml");
  if (border == std::string::npos) {
    return 0;
  }
  const MemoryFile file(all.substr(border + std::string(kBorder).size()));
  const base::Result<sim2d::MapImage> image = sim2d::readPgm(file.path());
  if (!image) {
    return 0;
  }
  const auto width = static_cast<std::size_t>(image->width);
  require(image->valuesPerRow() == width, "an image has one value per pixel");
  if (description) {
    for (const sim2d::MapRule rule : {sim2d::MapRule::Humble, sim2d::MapRule::Main}) {
      const sim2d::OccupancyGrid grid = sim2d::gridFromImage(*image, *description, rule);
      require(grid.width() == image->width && grid.height() == image->height,
              "a grid has the size of its image");
    }
  }
  return 0;
}
