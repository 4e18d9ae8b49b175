#include "look/resources.h"

#include <QtGlobal>

// Q_INIT_RESOURCE must stand outside of namespaces.
static void init_resources() {
  Q_INIT_RESOURCE(desktop);
  Q_INIT_RESOURCE(translations);
  Q_INIT_RESOURCE(icons);
}

namespace bole::desktop {

void take_in_resources() { init_resources(); }

}  // namespace bole::desktop
