#include "register_stages.h"

#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"
#ifdef BOLE_WITH_VTK
#include "report/make_report.h"
#endif

namespace bole::cli {

void register_stages() {
  pipeline::register_all_stages(pipeline::StageRegistry::global());
#ifdef BOLE_WITH_VTK
  report::register_stages(pipeline::StageRegistry::global());
#endif
}

}  // namespace bole::cli
