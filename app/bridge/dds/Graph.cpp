#include "app/bridge/dds/Graph.h"

namespace bridge {
namespace {

class GraphWriter {
 public:
  explicit GraphWriter(Distro distro) : gidSize_(distro == Distro::Humble ? 24 : 16) {}

  void number(std::size_t value) {
    while ((bytes.size() - kHeader) % 4 != 0) {
      bytes.push_back(0);
    }
    for (int shift = 0; shift < 32; shift += 8) {
      bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xffU));
    }
  }
  void text(const std::string& words) {
    number(words.size() + 1);
    bytes.insert(bytes.end(), words.begin(), words.end());
    bytes.push_back(0);
  }
  void gid(const Guid& guid) {
    bytes.insert(bytes.end(), guid.begin(), guid.end());
    bytes.resize(bytes.size() + gidSize_ - guid.size(), 0);
  }
  void gids(const std::vector<Guid>& guids) {
    number(guids.size());
    for (const Guid& guid : guids) {
      gid(guid);
    }
  }

  static constexpr std::size_t kHeader = 4;
  Bytes bytes = {0, 1, 0, 0};

 private:
  std::size_t gidSize_;
};

}  // namespace

Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro) {
  GraphWriter writer(distro);
  writer.gid(participant);
  writer.number(nodes.size());
  for (const NodeEndpoints& node : nodes) {
    writer.text(node.space);
    writer.text(node.name);
    writer.gids(node.readers);
    writer.gids(node.writers);
  }
  return std::move(writer.bytes);
}

}  // namespace bridge
