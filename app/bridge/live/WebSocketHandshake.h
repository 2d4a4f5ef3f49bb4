#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The WebSocket opening handshake (RFC 6455, section 4), without I/O.
namespace live {

constexpr std::size_t kLongestRequest = 8192;  // [B], limit for the HTTP request

/// Whether a page with this origin may connect. Browsers send the origin of the page that opens a
/// connection, so that other pages can neither watch nor control a run. Allowed are Foxglove's
/// pages (https://app.foxglove.dev, https://studio.foxglove.dev), local files, as used by the
/// desktop app, pages of this machine (localhost, 127.0.0.1, [::1]), and those in `more`. `null` is
/// not allowed, because any page can produce it.
bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more = {});

/// The value of Sec-WebSocket-Accept: base64(SHA-1(key + GUID)).
std::string acceptKeyOf(std::string_view key);

struct HandshakeResponse {
  std::string response;  // sent to the client in both cases
  bool isAccepted = false;
  std::string protocol;        // the negotiated subprotocol
  std::string rejectedOrigin;  // origin of a rejected page
};

/// `head`: the request including its empty line. `protocols`: the supported subprotocols. The
/// client's first supported one is selected; a client without any is rejected with status 400.
HandshakeResponse respondToHandshake(std::string_view head,
                                     const std::vector<std::string>& protocols,
                                     const std::vector<std::string>& origins = {});
/// The response to a client that is rejected because there are too many or its request is too long.
std::string httpError(std::string_view status, std::string_view text);

}  // namespace live
