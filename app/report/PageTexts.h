#pragma once

/// Texts of resources/report, put into the program by the build.
namespace report {

extern const char* const kPageText;    // the skeleton, holes as {{name}}
extern const char* const kStyleText;   // CSS
extern const char* const kReportText;  // script of every page
extern const char* const kPlayerText;  // script of the player

}  // namespace report
