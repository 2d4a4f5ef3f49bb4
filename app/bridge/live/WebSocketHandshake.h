#pragma once

#include <string>
#include <string_view>
#include <vector>

/// How a connection becomes one of WebSocket (RFC 6455, section 4), without input and output.
namespace live {

constexpr std::size_t kLongestRequest = 8192;  // [B], of the head with which a client begins

/// Whether a page of that origin may connect. Browsers tell the origin of the page that opens a
/// connection, so that no page of somebody else's can watch or steer a run: ours are Foxglove's
/// (https://app.foxglove.dev, https://studio.foxglove.dev), pages of files, as the app on the
/// desktop is one, pages of this machine (localhost, 127.0.0.1, [::1]), and those in `more`.
/// `null`, which any page can make itself, is none of them.
bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more = {});

/// The answer to "Sec-WebSocket-Key": base64(SHA-1(key + GUID)).
std::string acceptOf(std::string_view key);

struct HandshakeAnswer {
  std::string response;  // for the client, whether it may stay or not
  bool isAccepted = false;
  std::string protocol;       // what was agreed on
  std::string refusedOrigin;  // of a page that may not connect
};

/// `head`: the request up to and with its empty line. `protocols`: what we speak; the first that
/// the client names of them is taken, one who names none of them is refused with 400.
HandshakeAnswer answerHandshake(std::string_view head, const std::vector<std::string>& protocols,
                                const std::vector<std::string>& origins = {});
/// To one who comes when there are too many, or whose head is too long.
std::string httpRefusal(std::string_view status, std::string_view text);

}  // namespace live
