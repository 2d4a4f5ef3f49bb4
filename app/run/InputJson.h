#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/run/Sha256.h"

namespace app {

/// A file that was read, with its SHA-256. Private to this folder.
inline nlohmann::ordered_json inputJson(const std::string& path) {
  using Json = nlohmann::ordered_json;
  const std::optional<std::string> hash = sha256OfFile(path);
  return {{"path", path}, {"sha256", hash ? Json(*hash) : Json()}};
}

}  // namespace app
