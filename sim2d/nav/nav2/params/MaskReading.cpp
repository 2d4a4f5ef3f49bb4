#include "sim2d/nav/nav2/params/MaskReading.h"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace sim2d::nav2 {
namespace {

/// nav2_map_server: map_server, of a mask.
struct MaskServer {
  std::string topic = "map", yaml;
};
const std::vector<Nav2Key<MaskServer>>& maskServerKeys() {
  static const std::vector<Nav2Key<MaskServer>> kKeys = {
      {"topic_name", &MaskServer::topic, "", "Topic of the mask."},
      {"yaml_filename", &MaskServer::yaml, "", "The mask: the YAML of a map."}};
  return kKeys;
}

/// nav2_map_server: costmap_filter_info_server.
struct FilterInfo {
  int type = 0;  // 0 keepout, 1 speed in percent, 2 speed in m/s, 3 binary
  std::string topic = "costmap_filter_info", maskTopic = "filter_mask";
  double base = 0.0, multiplier = 1.0;
};
const std::vector<Nav2Key<FilterInfo>>& filterInfoKeys() {
  static const std::vector<Nav2Key<FilterInfo>> kKeys = {
      {"type", &FilterInfo::type, "", "0 keepout, 1 speed in percent, 2 speed in m/s, 3 binary."},
      {"filter_info_topic", &FilterInfo::topic, "", "Topic that filters subscribe to."},
      {"mask_topic", &FilterInfo::maskTopic, "", "Topic of the mask."},
      {"base", &FilterInfo::base, "", "Value of the filter: base + multiplier * mask."},
      {"multiplier", &FilterInfo::multiplier, "", "See base."}};
  return kKeys;
}

const std::vector<IdleKey>& idleMaskKeys() {
  static const std::vector<IdleKey> kKeys = {{"frame_id", "frames of maps coincide"}};
  return kKeys;
}

/// "/mask" and "mask" are the same topic of a robot without a namespace.
std::string topicOf(const std::string& name) {
  return name.substr(std::min(name.size(), name.find_first_not_of('/')));
}

bool hasKey(const NodeParameters& node, const char* key) {
  return std::any_of(node.given.begin(), node.given.end(), [key](const GivenParameter& given) {
    return given.name == key && !given.isForAll;
  });
}

bool isCostmap(const std::string& node) {
  return node == "local_costmap" || node == "global_costmap";
}

class MaskReader {
 public:
  MaskReader(const std::function<NodeReader(const std::string&)>& reader,
             const ParameterFile& file) {
    std::set<std::string> seen;
    for (const NodeParameters& node : file.nodes()) {
      if (isCostmap(node.node) || !seen.insert(node.node).second) {
        continue;
      }
      if (hasKey(node, "filter_info_topic")) {
        infos_.push_back(read(reader(node.node), filterInfoKeys(), FilterInfo()));
      } else if (hasKey(node, "yaml_filename") && node.node != "map_server") {
        servers_.push_back(read(reader(node.node), maskServerKeys(), MaskServer()));
      }
    }
  }

  void give(std::vector<CostmapPlugin>& filters) const {
    for (CostmapPlugin& filter : filters) {
      if (auto* const keepout = std::get_if<KeepoutFilterParameters>(&filter.parameters)) {
        const FilterInfo* const info = infoOf(keepout->filterInfoTopic, 0, 0);
        keepout->isMaskPublished = take(keepout->maskFile, info);
      } else if (auto* const speed = std::get_if<SpeedFilterParameters>(&filter.parameters)) {
        const FilterInfo* const info = infoOf(speed->filterInfoTopic, 1, 2);
        speed->isMaskPublished = take(speed->maskFile, info);
        if (speed->isMaskPublished) {
          speed->maskBase = info->base;
          speed->maskMultiplier = info->multiplier;
          speed->maskIsPercentage = info->type == 1;
        }
      } else if (auto* const binary = std::get_if<BinaryFilterParameters>(&filter.parameters)) {
        const FilterInfo* const info = infoOf(binary->filterInfoTopic, 3, 3);
        binary->isMaskPublished = take(binary->maskFile, info);
        if (binary->isMaskPublished) {
          binary->maskBase = info->base;
          binary->maskMultiplier = info->multiplier;
        }
      }
    }
  }

 private:
  template <class Parameters>
  static Parameters read(NodeReader node, const std::vector<Nav2Key<Parameters>>& keys,
                         Parameters parameters) {
    parameters = node.read({}, keys, idleMaskKeys(), std::move(parameters));
    node.finish();
    return parameters;
  }

  /// Nav2's filters refuse a message of another type.
  const FilterInfo* infoOf(const std::string& topic, int lowest, int highest) const {
    const auto found = std::find_if(infos_.begin(), infos_.end(), [&](const FilterInfo& info) {
      return topicOf(info.topic) == topicOf(topic) && info.type >= lowest && info.type <= highest;
    });
    return found == infos_.end() || topic.empty() ? nullptr : &*found;
  }

  /// False: nothing was taken.
  bool take(std::string& file, const FilterInfo* info) const {
    if (!file.empty() || info == nullptr) {
      return false;
    }
    const auto found = std::find_if(servers_.begin(), servers_.end(), [&](const MaskServer& each) {
      return topicOf(each.topic) == topicOf(info->maskTopic);
    });
    file = found == servers_.end() ? std::string() : found->yaml;
    return !file.empty();
  }

  std::vector<FilterInfo> infos_;
  std::vector<MaskServer> servers_;
};

}  // namespace

void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file) {
  const MaskReader masks(reader, file);
  masks.give(to.localCostmap.filters);
  masks.give(to.globalCostmap.filters);
}

}  // namespace sim2d::nav2
