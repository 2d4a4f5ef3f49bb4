#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/live/FoxgloveServer.h"

/// The messages of the server: JSON texts and little-endian binary ones.
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

std::string timeMessage(std::uint64_t time);  // [ns]
/// The beginning of a topic message, which its payload follows.
std::string messageHead(std::uint32_t subscription, std::uint64_t time);
/// `payload`: in the encoding of the call.
std::string callResponse(const request::CallService& call, const std::string& payload);

}  // namespace live
