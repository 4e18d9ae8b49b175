// What the readers of layouts share.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include "io/core/views/found_views.h"
#include "io/core/views/numbered_files.h"
#include "io/core/views/pose_list.h"

namespace bole::io {

inline constexpr double views_per_second = 30;  // where a layout has no times

bool is_folder(const std::filesystem::path& path);
bool is_there(const std::filesystem::path& path);

// The first of these entries of a folder that exists, or an empty path.
std::filesystem::path first_of(const std::filesystem::path& folder, std::initializer_list<const char*> names);

std::string lower_case(std::string text);

// Runs `take`, which reads poses that views can do without: what makes them unusable becomes a finding.
void allow_damaged_poses(FoundViews& found, const std::function<void()>& take);

// What is missing in the numbers, other names and repeated numbers: as findings.
void tell_numbering(const NumberedFiles& images, const std::string& folder, Report& report);

// Depth images by number. Where a view has none, the path is that of a file that is not there, so that it is counted
// with the missing ones.
void take_depth_images(const NumberedFiles& color, const NumberedFiles& depth, const std::filesystem::path& folder,
                       FoundViews& found);

// One pose per view. By the keys, where they are the numbers of the images, else by rank, where there are as many poses
// as numbers from the first image to the last. Else none is used, and a finding says so.
void take_listed_poses(const std::vector<ListedPose>& poses, const NumberedFiles& color, const std::string& name,
                       FoundViews& found);

// Lengths are in a unit of the dataset that nobody knows.
void tell_unknown_scale(const std::string& file, FoundViews& found);

}  // namespace bole::io
