// What is compiled into the program: modes, pipelines, translations.
#pragma once

namespace bole::desktop {

// Before any of it is read: the linker leaves resources of a static library out unless somebody asks for them.
void take_in_resources();

}  // namespace bole::desktop
