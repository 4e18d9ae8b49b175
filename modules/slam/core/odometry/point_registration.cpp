#include "slam/core/odometry/point_registration.h"

#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>

#include <cmath>

namespace bole::slam {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
constexpr std::size_t min_points = 20;

Cloud::Ptr as_cloud(const std::vector<Eigen::Vector3f>& points) {
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const auto& p : points) cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

template <class Method>
PointRegistration aligned(Method& method, const std::vector<Eigen::Vector3f>& source,
                          const std::vector<Eigen::Vector3f>& target, const Pose& guess) {
  PointRegistration out{guess, false};
  if (source.size() < min_points || target.size() < min_points) return out;
  method.setInputTarget(as_cloud(target));
  method.setInputSource(as_cloud(source));
  Cloud moved;
  method.align(moved, guess.matrix().cast<float>());
  const Eigen::Matrix4d T = method.getFinalTransformation().template cast<double>();
  if (!method.hasConverged() || !T.allFinite()) return out;
  out.T_target_source = Pose(T);
  out.T_target_source.linear() = Eigen::Quaterniond(out.T_target_source.linear()).normalized().toRotationMatrix();
  out.converged = true;
  out.rms = std::sqrt(method.getFitnessScore());
  return out;
}

}  // namespace

PointRegistration register_by_ndt(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double cell_size) {
  pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> ndt;
  ndt.setMinPointPerVoxel(5);
  ndt.setResolution(static_cast<float>(cell_size));
  ndt.setStepSize(0.1);
  ndt.setTransformationEpsilon(1e-4);
  ndt.setMaximumIterations(40);
  return aligned(ndt, source, target, guess);
}

PointRegistration register_by_icp(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double reach) {
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setMaxCorrespondenceDistance(reach);
  icp.setTransformationEpsilon(1e-8);
  icp.setEuclideanFitnessEpsilon(1e-6);
  icp.setMaximumIterations(60);
  return aligned(icp, source, target, guess);
}

}  // namespace bole::slam
