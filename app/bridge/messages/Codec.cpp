#include "app/bridge/messages/Codec.h"

#include <algorithm>
#include <cstring>

#include "app/bridge/messages/AllMessages.h"
#include "sim2d/base/Find.h"

namespace bridge {
namespace {

constexpr std::size_t kEncapsulation = 4;  // [B]
constexpr std::size_t kMostPadding = 3;    // [B]

}  // namespace

CdrReader::CdrReader(std::string_view bytes) {
  if (bytes.size() < kEncapsulation) {
    fail("cdr.no-encapsulation", bytes.size());
    return;
  }
  const int order = static_cast<unsigned char>(bytes[1]);
  if (bytes[0] != 0 || order > 1) {
    fail("cdr.encapsulation",
         static_cast<unsigned char>(bytes[0]) * 256U + static_cast<unsigned>(order));
    return;
  }
  isSwapped_ = (order == 1) != kIsLittleEndianHost;
  bytes_ = bytes.substr(kEncapsulation);
}

void CdrReader::fail(std::string_view code, std::uint64_t found) {
  if (code_.empty()) {
    code_ = code;
    found_ = found;
  }
}

void CdrReader::readNumbers(void* first, std::size_t size, std::size_t count) {
  if (hasFailed()) {
    return;
  }
  const std::size_t at = (position_ + size - 1) / size * size;
  if (at > bytes_.size() || (bytes_.size() - at) / size < count) {
    fail("cdr.too-short", bytes_.size());
    return;
  }
  std::memcpy(first, bytes_.data() + at, size * count);
  if (isSwapped_) {
    swapBytes(static_cast<char*>(first), size, count);
  }
  position_ = at + size * count;
}

bool CdrReader::readBool() {
  std::uint8_t value = 0;
  read(value);
  if (value > 1) {
    fail("cdr.bad-bool", value);
  }
  return value == 1;
}

std::uint32_t CdrReader::readLength(std::size_t least, std::size_t bound) {
  std::uint32_t count = 0;
  read(count);
  if (count > rest() / least || (bound > 0 && count > bound)) {
    fail("cdr.bad-length", count);
  }
  return hasFailed() ? 0 : count;
}

void CdrReader::text(std::string& text, std::size_t bound) {
  const std::uint32_t size = readLength(1, bound > 0 ? bound + 1 : 0);  // including the NUL
  if (hasFailed() || size == 0) {  // some writers omit the NUL of an empty string
    text.clear();
    return;
  }
  if (bytes_[position_ + size - 1] != '\0') {
    fail("cdr.open-text", size);
    return;
  }
  text.assign(bytes_.data() + position_, size - 1);
  position_ += size;
}

void CdrReader::requireEnd() {
  if (!hasFailed() && rest() > kMostPadding) {
    field_ = "";
    fail("cdr.rest", rest());
  }
}

base::Diagnostic CdrReader::problem(std::string_view type) const {
  if (code_ == "cdr.too-short" || code_ == "cdr.bad-bool" || code_ == "cdr.bad-length" ||
      code_ == "cdr.open-text") {
    return base::error(code_, {type, field_, found_});
  }
  return base::error(code_, {type, found_});
}

namespace {

constexpr std::size_t kLeastGrowth = 256, kMostGrowth = 4096;  // [bytes]; fits in the cache

template <class... M>
std::vector<KnownType> typesOf(TypeList<M...> /*list*/) {
  return {{M::kType, M::kDefinition}...};
}

}  // namespace

CdrWriter::CdrWriter(std::string& to) : output_(to) {
  output_.append("\0\1\0\0", 4);  // plain CDR, little endian; no options
  bodyBegin_ = position_ = capacity_ = output_.size();
  data_ = output_.data();
}

void CdrWriter::text(std::string_view text) {
  scalar(static_cast<std::uint32_t>(text.size() + 1));
  ensureCapacity(text.size() + 1);
  std::copy(text.begin(), text.end(), data_ + position_);
  position_ += text.size() + 1;
}

void CdrWriter::grow(std::size_t more) {
  const std::size_t least = position_ + more;
  const std::size_t wanted = least + std::clamp(position_, kLeastGrowth, kMostGrowth);
  output_.resize(output_.capacity() >= least ? std::min(output_.capacity(), wanted) : wanted);
  data_ = output_.data();
  capacity_ = output_.size();
}

void CdrWriter::flush() {
  output_.resize(position_);
  capacity_ = position_;
}

std::string ddsTypeName(std::string_view type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  if (first == std::string_view::npos || first == last) {
    return std::string(type);
  }
  return std::string(type.substr(0, first)) +
         "::" + std::string(type.substr(first + 1, last - first - 1)) +
         "::dds_::" + std::string(type.substr(last + 1)) + "_";
}

std::string rosTypeName(std::string_view ddsType) {
  constexpr std::string_view kInfix = "::dds_::";
  const std::size_t infix = ddsType.find(kInfix);
  const std::size_t first = ddsType.find("::");
  if (infix == std::string_view::npos || first >= infix || ddsType.back() != '_') {
    return {};
  }
  const std::string_view kind = ddsType.substr(first + 2, infix - first - 2);
  std::string_view name = ddsType.substr(infix + kInfix.size());
  name.remove_suffix(1);
  return std::string(ddsType.substr(0, first)) + "/" + std::string(kind) + "/" + std::string(name);
}

const std::vector<KnownType>& knownTypes() {
  static const std::vector<KnownType> kTypes = typesOf(AllMessages{});
  return kTypes;
}

const KnownType* findType(std::string_view type) {
  return base::findBy(knownTypes(), &KnownType::type, type);
}

}  // namespace bridge
