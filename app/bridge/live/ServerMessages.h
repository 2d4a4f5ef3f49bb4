#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"

/// The JSON text messages of the server.
namespace live {

std::string serverInfoText(const FoxgloveSettings& settings);
/// Channels are numbered from 1.
std::string advertiseText(const std::vector<Channel>& channels);
std::string servicesText(const std::vector<Service>& services);

enum class StatusLevel { Info, Warning, Error };
/// `id`: a later status with the same id replaces this one.
std::string statusText(StatusLevel level, const std::string& message, const std::string& id = {});
std::string parametersText(const std::vector<NamedValue>& values,
                           const std::optional<std::string>& id);
std::string callFailureText(std::uint32_t service, std::uint32_t call, const std::string& why);

}  // namespace live
