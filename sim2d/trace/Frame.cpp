#include "sim2d/trace/Frame.h"

#include <tuple>

namespace sim2d {
namespace {

template <class Columns>
bool areEqualColumns(const Columns& a, const Columns& b) {
  bool same = true;
  Columns::eachColumn([&](auto column) { same = same && a.*column == b.*column; });
  return same;
}

}  // namespace

bool operator==(const BodyColumns& a, const BodyColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const HumanColumns& a, const HumanColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const ForceColumns& a, const ForceColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const Event& a, const Event& b) {
  return std::tie(a.kind, a.id, a.hasId, a.other, a.hasOther, a.text) ==
         std::tie(b.kind, b.id, b.hasId, b.other, b.hasOther, b.text);
}

}  // namespace sim2d
