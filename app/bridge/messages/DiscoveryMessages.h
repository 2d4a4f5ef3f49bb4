#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/bridge/messages/FieldTraits.h"

/// Messages of rmw_dds_common: which node owns which endpoint.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::rmw_dds_common {

/// An RTPS GUID, padded with zeros. Size: 24 in Humble, 16 from Iron on, under the same type name.
template <std::size_t Size>
struct Gid {
  static constexpr const char* kType = "rmw_dds_common/msg/Gid";

  std::array<std::uint8_t, Size> data{};

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("data", self.data);
  }
};

template <std::size_t Size>
struct NodeEntitiesInfo {
  static constexpr const char* kType = "rmw_dds_common/msg/NodeEntitiesInfo";

  BoundedString<256> nodeNamespace;  // "/" or "/ns"
  BoundedString<256> nodeName;
  std::vector<Gid<Size>> readerGidSeq;
  std::vector<Gid<Size>> writerGidSeq;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("node_namespace", self.nodeNamespace);
    field("node_name", self.nodeName);
    field("reader_gid_seq", self.readerGidSeq);
    field("writer_gid_seq", self.writerGidSeq);
  }
};

/// All nodes of one participant, published on the topic ros_discovery_info.
template <std::size_t Size>
struct ParticipantEntitiesInfo {
  static constexpr const char* kType = "rmw_dds_common/msg/ParticipantEntitiesInfo";

  Gid<Size> gid;
  std::vector<NodeEntitiesInfo<Size>> nodeEntitiesInfoSeq;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("gid", self.gid);
    field("node_entities_info_seq", self.nodeEntitiesInfoSeq);
  }
};

}  // namespace bridge::rmw_dds_common
