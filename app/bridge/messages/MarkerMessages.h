#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/NavigationMessages.h"

/// Messages of visualization_msgs. Field names, types and order match the .msg files of ROS 2
/// Humble to Jazzy. The constants, which are not transmitted, are those of Jazzy, a superset of the
/// others.
namespace bridge::visualization_msgs {

struct UVCoordinate {
  static constexpr const char* kType = "visualization_msgs/msg/UVCoordinate";

  float u = 0;
  float v = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("u", self.u);
    field("v", self.v);
  }
};

struct MeshFile {
  static constexpr const char* kType = "visualization_msgs/msg/MeshFile";

  std::string filename;
  std::vector<std::uint8_t> data;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("filename", self.filename);
    field("data", self.data);
  }
};

/// lifetime 0: until it is deleted. type and action are constants of this struct.
struct Marker {
  static constexpr const char* kType = "visualization_msgs/msg/Marker";
  static constexpr std::int32_t kArrow = 0;
  static constexpr std::int32_t kCube = 1;
  static constexpr std::int32_t kSphere = 2;
  static constexpr std::int32_t kCylinder = 3;
  static constexpr std::int32_t kLineStrip = 4;
  static constexpr std::int32_t kLineList = 5;
  static constexpr std::int32_t kCubeList = 6;
  static constexpr std::int32_t kSphereList = 7;
  static constexpr std::int32_t kPoints = 8;
  static constexpr std::int32_t kTextViewFacing = 9;
  static constexpr std::int32_t kMeshResource = 10;
  static constexpr std::int32_t kTriangleList = 11;
  static constexpr std::int32_t kArrowStrip = 12;  // since Jazzy
  static constexpr std::int32_t kAdd = 0;
  static constexpr std::int32_t kModify = 0;
  static constexpr std::int32_t kDelete = 2;
  static constexpr std::int32_t kDeleteall = 3;

  std_msgs::Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = 0;
  geometry_msgs::Pose pose;
  geometry_msgs::Vector3 scale;
  std_msgs::ColorRGBA color;
  builtin_interfaces::Duration lifetime;
  bool frameLocked = false;
  std::vector<geometry_msgs::Point> points;
  std::vector<std_msgs::ColorRGBA> colors;
  std::string textureResource;
  sensor_msgs::CompressedImage texture;
  std::vector<UVCoordinate> uvCoordinates;
  std::string text;
  std::string meshResource;
  MeshFile meshFile;
  bool meshUseEmbeddedMaterials = false;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("ns", self.ns);
    field("id", self.id);
    field("type", self.type);
    field("action", self.action);
    field("pose", self.pose);
    field("scale", self.scale);
    field("color", self.color);
    field("lifetime", self.lifetime);
    field("frame_locked", self.frameLocked);
    field("points", self.points);
    field("colors", self.colors);
    field("texture_resource", self.textureResource);
    field("texture", self.texture);
    field("uv_coordinates", self.uvCoordinates);
    field("text", self.text);
    field("mesh_resource", self.meshResource);
    field("mesh_file", self.meshFile);
    field("mesh_use_embedded_materials", self.meshUseEmbeddedMaterials);
  }
  template <class F>
  static void constants(F&& constant) {
    constant("ARROW", kArrow);
    constant("CUBE", kCube);
    constant("SPHERE", kSphere);
    constant("CYLINDER", kCylinder);
    constant("LINE_STRIP", kLineStrip);
    constant("LINE_LIST", kLineList);
    constant("CUBE_LIST", kCubeList);
    constant("SPHERE_LIST", kSphereList);
    constant("POINTS", kPoints);
    constant("TEXT_VIEW_FACING", kTextViewFacing);
    constant("MESH_RESOURCE", kMeshResource);
    constant("TRIANGLE_LIST", kTriangleList);
    constant("ARROW_STRIP", kArrowStrip);
    constant("ADD", kAdd);
    constant("MODIFY", kModify);
    constant("DELETE", kDelete);
    constant("DELETEALL", kDeleteall);
  }
};

struct MarkerArray {
  static constexpr const char* kType = "visualization_msgs/msg/MarkerArray";

  std::vector<Marker> markers;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("markers", self.markers);
  }
};

}  // namespace bridge::visualization_msgs
