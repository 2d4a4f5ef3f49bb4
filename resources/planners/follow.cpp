// Drives straight to the goal and gives way to people ahead. See PROTOCOL.md.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

using Json = nlohmann::json;

static Json command(const Json& robot, const Json& seen) {
  const double maxVel = robot["limits"]["max_vel"], maxOmega = robot["limits"]["max_omega"];
  const double maxAcc = robot["limits"]["max_acc"], radius = robot["radius"];
  const double px = seen["pose"]["x"], py = seen["pose"]["y"], heading = seen["pose"]["heading"];
  const double x = seen["goal"][0].get<double>() - px, y = seen["goal"][1].get<double>() - py;
  const double turn = std::remainder(std::atan2(y, x) - heading, 2.0 * std::acos(-1.0));
  double speed = std::min(maxVel, std::sqrt(maxAcc * std::hypot(x, y)));
  for (const Json& body : seen["bodies"]) {
    const double bx = body["position"][0].get<double>() - px;
    const double by = body["position"][1].get<double>() - py;
    const double gap = std::hypot(bx, by) - body["radius"].get<double>() - radius;
    if (std::cos(std::atan2(by, bx) - heading) > 0.5 && gap < 1.5) {
      speed = std::min(speed, maxVel * std::max(0.0, gap - 0.5));
    }
  }
  return {{"linear", std::fabs(turn) < 0.5 ? speed : 0.0},
          {"angular", std::clamp(2.0 * turn, -maxOmega, maxOmega)}};
}

int main() {
  std::string line;
  std::getline(std::cin, line);
  const Json robot = Json::parse(line)["robot"];
  std::cout << R"({"ready": true, "name": "follow"})" << std::endl;
  while (std::getline(std::cin, line) && !Json::parse(line).contains("end")) {
    std::cout << command(robot, Json::parse(line)) << std::endl;
  }
}
