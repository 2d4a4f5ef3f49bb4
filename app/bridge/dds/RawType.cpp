#include "app/bridge/dds/RawType.h"

#include <cstring>

namespace bridge {
namespace {

constexpr std::uint32_t kStartSize = 512;  // [bytes]; grows as needed

}  // namespace

RawType::RawType(const std::string& name) {
  setName(name.c_str());
  m_typeSize = kStartSize;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool RawType::serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) {
  const Bytes& bytes = *static_cast<const Bytes*>(data);
  if (bytes.size() > payload->max_size) {
    return false;
  }
  std::memcpy(payload->data, bytes.data(), bytes.size());
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = CDR_LE;
  return true;
}

bool RawType::deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) {
  const auto* const first = reinterpret_cast<const char*>(payload->data);
  static_cast<Bytes*>(data)->assign(first, payload->length);
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  const auto size = static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size());
  return [size] { return size; };
}

void* RawType::createData() {
  return new Bytes;
}

void RawType::deleteData(void* data) {
  delete static_cast<Bytes*>(data);
}

bool RawType::getKey(void* /*data*/, eprosima::fastrtps::rtps::InstanceHandle_t* /*handle*/,
                     bool /*forceMd5*/) {
  return false;
}

}  // namespace bridge
