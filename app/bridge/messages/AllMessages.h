#pragma once

#include "app/bridge/messages/ActionMessages.h"
#include "app/bridge/messages/BasicMessages.h"
#include "app/bridge/messages/DiscoveryMessages.h"
#include "app/bridge/messages/GeometryMessages.h"
#include "app/bridge/messages/HunavMessages.h"
#include "app/bridge/messages/HunavServices.h"
#include "app/bridge/messages/MarkerMessages.h"
#include "app/bridge/messages/NavigationMessages.h"
#include "app/bridge/messages/ParameterMessages.h"
#include "app/bridge/messages/ParameterServices.h"

namespace bridge {

template <class... M>
struct TypeList {};

/// Every message, request and response. Types that differ between distributions under the same name
/// are listed in their Humble version.
using AllMessages = TypeList<
    builtin_interfaces::Time, builtin_interfaces::Duration, std_msgs::Header, std_msgs::String,
    std_msgs::Empty, std_msgs::ColorRGBA, rosgraph_msgs::Clock, std_srvs::Empty::Request,
    std_srvs::Empty::Response, std_srvs::Trigger::Request, std_srvs::Trigger::Response,
    std_srvs::SetBool::Request, std_srvs::SetBool::Response, geometry_msgs::Vector3,
    geometry_msgs::Point, geometry_msgs::Point32, geometry_msgs::Quaternion, geometry_msgs::Pose,
    geometry_msgs::PoseStamped, geometry_msgs::Twist, geometry_msgs::TwistStamped,
    geometry_msgs::Transform, geometry_msgs::TransformStamped, geometry_msgs::PoseWithCovariance,
    geometry_msgs::PoseWithCovarianceStamped, geometry_msgs::TwistWithCovariance,
    geometry_msgs::Polygon, tf2_msgs::TFMessage, nav_msgs::Odometry, nav_msgs::MapMetaData,
    nav_msgs::OccupancyGrid, nav_msgs::Path, nav_msgs::GetMap::Request, nav_msgs::GetMap::Response,
    sensor_msgs::LaserScan, sensor_msgs::CompressedImage, visualization_msgs::UVCoordinate,
    visualization_msgs::MeshFile, visualization_msgs::Marker, visualization_msgs::MarkerArray,
    hunav_msgs::AgentBehavior, hunav_msgs::Agent, hunav_msgs::Agents, people_msgs::Person,
    people_msgs::People, hunav_msgs::ComputeAgents::Request, hunav_msgs::ComputeAgents::Response,
    hunav_msgs::ComputeAgent::Request, hunav_msgs::ComputeAgent::Response,
    hunav_msgs::MoveAgent::Request, hunav_msgs::MoveAgent::Response,
    hunav_msgs::ResetAgents::Request, hunav_msgs::ResetAgents::Response,
    hunav_msgs::GetAgents::Request, hunav_msgs::GetAgents::Response,
    hunav_msgs::GetParameters::Request, hunav_msgs::GetParameters::Response,
    hunav_msgs::StartEvaluation::Request, hunav_msgs::StartEvaluation::Response,
    rcl_interfaces::Log, rcl_interfaces::ParameterType, rcl_interfaces::ParameterValue,
    rcl_interfaces::Parameter, rcl_interfaces::SetParametersResult,
    rcl_interfaces::ListParametersResult, rcl_interfaces::ParameterEvent,
    rcl_interfaces::FloatingPointRange, rcl_interfaces::IntegerRange,
    rcl_interfaces::ParameterDescriptor, rcl_interfaces::GetParameters::Request,
    rcl_interfaces::GetParameters::Response, rcl_interfaces::GetParameterTypes::Request,
    rcl_interfaces::GetParameterTypes::Response, rcl_interfaces::SetParameters::Request,
    rcl_interfaces::SetParameters::Response, rcl_interfaces::SetParametersAtomically::Request,
    rcl_interfaces::SetParametersAtomically::Response, rcl_interfaces::DescribeParameters::Request,
    rcl_interfaces::DescribeParameters::Response, rcl_interfaces::ListParameters::Request,
    rcl_interfaces::ListParameters::Response, unique_identifier_msgs::UUID, action_msgs::GoalInfo,
    action_msgs::GoalStatus, action_msgs::GoalStatusArray, action_msgs::CancelGoal::Request,
    action_msgs::CancelGoal::Response, nav2_msgs::NavigateToPose::Goal,
    nav2_msgs::NavigateToPose::HumbleResult, nav2_msgs::NavigateToPose::Feedback,
    nav2_msgs::NavigateToPose::FeedbackMessage, nav2_msgs::NavigateToPose::SendGoal::Request,
    nav2_msgs::NavigateToPose::SendGoal::Response,
    nav2_msgs::NavigateToPose::GetResult<nav2_msgs::NavigateToPose::HumbleResult>::Request,
    nav2_msgs::NavigateToPose::GetResult<nav2_msgs::NavigateToPose::HumbleResult>::Response,
    rmw_dds_common::Gid<24>, rmw_dds_common::NodeEntitiesInfo<24>,
    rmw_dds_common::ParticipantEntitiesInfo<24>>;

}  // namespace bridge
