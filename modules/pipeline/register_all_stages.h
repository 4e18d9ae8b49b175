// Adds the stages of every core module. Defined in the library bole_stages, which the build writes.
#pragma once

namespace bole::pipeline {

class StageRegistry;
void register_all_stages(StageRegistry& registry);

}  // namespace bole::pipeline
