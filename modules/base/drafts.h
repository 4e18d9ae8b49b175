// Temporary files and folders that stand for a result until it is whole, and what is left of them.
#pragma once

#include <cstddef>
#include <filesystem>

namespace bole {
inline namespace base {

// Temporary files and folders of this process, removed by remove_own_drafts() when the program must end at once. Those
// of atomic_file.h are remembered by themselves.
void remember_draft(const std::filesystem::path& draft);
void forget_draft(const std::filesystem::path& draft);
void remove_own_drafts();

// Whether a process with this id runs on this machine.
bool process_runs(long id);

// Removes temporary files in a folder and all folders in it that processes left which run no more. Returns their
// number. What cannot be removed stays.
std::size_t remove_abandoned_drafts(const std::filesystem::path& folder);

}  // namespace base
}  // namespace bole
