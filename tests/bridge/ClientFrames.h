#pragma once

#include <cstddef>
#include <string>

#include <QByteArray>

/// Frames as a client sends them, made by code of the tests' own.
namespace client {

/// "81 05 48" -> the bytes.
inline std::string bytesOf(const char* hex) {
  return QByteArray::fromHex(hex).toStdString();
}

/// One frame; `first` is its first byte (0x81: a whole text, 0x01: a first fragment). Masked.
inline std::string frame(int first, const std::string& payload) {
  const char mask[] = {0x37, static_cast<char>(0xfa), 0x21, 0x3d};  // that of the RFC's examples
  std::string bytes(1, static_cast<char>(first));
  const std::size_t size = payload.size();
  const auto append = [&](int count) {
    while (count-- > 0) {
      bytes += static_cast<char>((size >> (8 * count)) % 256);
    }
  };
  if (size < 126) {
    bytes += static_cast<char>(128 + size);
  } else if (size < 65536) {
    bytes += static_cast<char>(254);
    append(2);
  } else {
    bytes += static_cast<char>(255);
    append(8);
  }
  bytes.append(mask, sizeof mask);
  for (std::size_t i = 0; i < size; ++i) {
    bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  }
  return bytes;
}

}  // namespace client
