// Standard input, output and error of a program that may be started without them, or with an output that takes
// nothing. One thread.
#pragma once

namespace lentray::tool {

/// First thing in main(): opens what is closed so that every use of it fails, and no file gets its number.
void hold_standard_streams();

/// Last thing in main(): `status`, or 1 with a message if standard output did not take all that was written to it.
int finish_standard_output(const char* program, int status);

}  // namespace lentray::tool
