#include "app/bridge/live/WebSocketHandshake.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <openssl/evp.h>

#include "sim2d/base/Text.h"

namespace live {

namespace {

constexpr std::string_view kLineEnd = "\r\n";
constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // RFC 6455, 1.3
constexpr const char* kBadRequest = "400 Bad Request";
constexpr const char* kUpgradeRequired = "426 Upgrade Required";

using Headers = std::map<std::string, std::string>;  // by lower-case name

bool isTokenCharacter(char c) {
  return base::isLetter(c) || base::isDigit(c) ||
         std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

/// Headers with a single value must not be repeated.
bool mayRepeat(const std::string& name) {
  return name != "host" && name != "origin" && name != "sec-websocket-key" &&
         name != "sec-websocket-version";
}

bool addHeader(std::string_view line, Headers& to) {
  const std::size_t colon = line.find(':');
  const std::string_view name = line.substr(0, colon);
  const bool isName = colon != std::string_view::npos && !name.empty() &&
                      std::all_of(name.begin(), name.end(), isTokenCharacter);
  if (!isName || line.find('\0') != std::string_view::npos) {
    return false;
  }
  const std::string key = base::toLower(name);
  const std::string value = base::trimmed(line.substr(colon + 1));
  const auto [entry, isNew] = to.emplace(key, value);
  if (!isNew) {
    entry->second += ", " + value;
  }
  return isNew || mayRepeat(key);
}

/// Nothing: not an HTTP/1.1 request.
std::optional<Headers> headersOf(std::string_view head, bool& isGet) {
  Headers headers;
  bool isFirst = true;
  while (!head.empty()) {
    const std::size_t end = head.find(kLineEnd);
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    const std::string_view line = head.substr(0, end);
    head.remove_prefix(end + kLineEnd.size());
    if (isFirst) {
      const std::vector<std::string> words = base::split(line, ' ');
      isGet = words.size() == 3 && words[0] == "GET" && words[1].rfind('/', 0) == 0;
      if (words.size() != 3 || words[2] != "HTTP/1.1") {
        return std::nullopt;
      }
    } else if (!line.empty() && !addHeader(line, headers)) {
      return std::nullopt;
    }
    isFirst = false;
  }
  return headers;
}

std::vector<std::string> listOf(const Headers& headers, const char* name) {
  const auto found = headers.find(name);
  std::vector<std::string> words;
  if (found != headers.end()) {
    words = base::split(found->second, ',');
    std::transform(words.begin(), words.end(), words.begin(),
                   [](const std::string& word) { return base::trimmed(word); });
  }
  return words;
}

bool holds(const Headers& headers, const char* name, const std::string& wanted) {
  const std::vector<std::string> words = listOf(headers, name);
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return base::toLower(word) == wanted; });
}

/// Whether the key is 16 bytes in base64.
bool isKey(const std::string& key) {
  const auto isDigitOf64 = [](char c) {
    return base::isLetter(c) || base::isDigit(c) || c == '+' || c == '/';
  };
  return key.size() == 24 && key.substr(22) == "==" &&
         std::all_of(key.begin(), key.begin() + 22, isDigitOf64);
}

/// The host of "http://localhost:8080". Nothing for other schemes and for text after the port.
std::optional<std::string> webHostOf(std::string_view origin) {
  for (const std::string_view scheme :
       {std::string_view("http://"), std::string_view("https://")}) {
    if (origin.substr(0, scheme.size()) == scheme) {
      std::string_view host = origin.substr(scheme.size());
      const std::size_t port =
          host.find(':', host.find(']') == std::string_view::npos ? 0 : host.find(']'));
      const std::string_view digits =
          port == std::string_view::npos ? std::string_view("0") : host.substr(port + 1);
      if (digits.empty() || !std::all_of(digits.begin(), digits.end(), base::isDigit)) {
        return std::nullopt;
      }
      return std::string(host.substr(0, port));
    }
  }
  return std::nullopt;
}

HandshakeResponse rejected(const char* status, std::string_view text) {
  HandshakeResponse handshake;
  handshake.response = httpError(status, text);
  return handshake;
}

const std::string& valueOf(const Headers& headers, const char* name) {
  static const std::string kNone;
  const auto found = headers.find(name);
  return found == headers.end() ? kNone : found->second;
}

/// The response to an invalid request; nothing if it is valid.
std::optional<HandshakeResponse> checkRequest(const std::optional<Headers>& headers, bool isGet) {
  if (!headers || !isGet || headers->count("host") == 0) {
    return rejected(kBadRequest, "This is not a supported HTTP 1.1 request.");
  }
  if (!holds(*headers, "upgrade", "websocket") || !holds(*headers, "connection", "upgrade")) {
    return rejected(kUpgradeRequired,
                    "This is the live view of hunavsim. Open it in Foxglove: Open connection, "
                    "Foxglove WebSocket, ws:// and this address.");
  }
  if (valueOf(*headers, "sec-websocket-version") != "13") {
    return rejected(kUpgradeRequired, "Only version 13 of WebSocket is supported.");
  }
  if (!isKey(valueOf(*headers, "sec-websocket-key"))) {
    return rejected(kBadRequest, "Sec-WebSocket-Key is not 16 bytes in base64.");
  }
  return std::nullopt;
}

}  // namespace

bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more) {
  const auto same = [&](std::string_view other) { return origin == other; };
  if (same("https://app.foxglove.dev") || same("https://studio.foxglove.dev") || same("file://") ||
      std::any_of(more.begin(), more.end(), same)) {
    return true;
  }
  const std::optional<std::string> host = webHostOf(origin);
  return host && (*host == "localhost" || *host == "127.0.0.1" || *host == "[::1]");
}

std::string acceptKeyOf(std::string_view key) {
  const std::string text = std::string(key).append(kGuid);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha1(), nullptr);
  std::array<unsigned char, std::size_t{2} * EVP_MAX_MD_SIZE> base64{};
  const int length = EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(size));
  return {base64.begin(), base64.begin() + length};
}

std::string httpError(std::string_view status, std::string_view text) {
  std::string response = "HTTP/1.1 ";
  response.append(status);
  response += "\r\nConnection: close\r\nContent-Type: text/plain; charset=utf-8\r\n";
  if (status == kUpgradeRequired) {
    response += "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n";
  }
  response += "Content-Length: " + std::to_string(text.size() + 1) + "\r\n\r\n";
  return response.append(text) + "\n";
}

HandshakeResponse respondToHandshake(std::string_view head,
                                     const std::vector<std::string>& protocols,
                                     const std::vector<std::string>& origins) {
  bool isGet = false;
  const std::optional<Headers> headers = headersOf(head, isGet);
  if (std::optional<HandshakeResponse> wrong = checkRequest(headers, isGet)) {
    return *std::move(wrong);
  }
  const bool isPage = headers->count("origin") > 0;  // programs may omit the origin
  const std::string& origin = valueOf(*headers, "origin");
  if (isPage && !isAllowedOrigin(origin, origins)) {
    HandshakeResponse handshake =
        rejected("403 Forbidden", "Pages of this origin are not allowed to connect.");
    handshake.rejectedOrigin = origin;
    return handshake;
  }
  const std::vector<std::string> offered = listOf(*headers, "sec-websocket-protocol");
  const auto chosen =
      std::find_first_of(offered.begin(), offered.end(), protocols.begin(), protocols.end());
  if (chosen == offered.end()) {
    return rejected(kBadRequest,
                    "One of these subprotocols is required: " + base::join(protocols, ", ") + ".");
  }
  HandshakeResponse handshake;
  handshake.isAccepted = true;
  handshake.protocol = *chosen;
  handshake.response =
      "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
      "Connection: Upgrade\r\nSec-WebSocket-Accept: " +
      acceptKeyOf(valueOf(*headers, "sec-websocket-key")) +
      "\r\nSec-WebSocket-Protocol: " + *chosen + "\r\n\r\n";
  return handshake;
}

}  // namespace live
