#pragma once

/// The files of resources/report, embedded by the build.
namespace report {

extern const char* const kPageText;    // HTML template with placeholders {{name}}
extern const char* const kStyleText;   // CSS
extern const char* const kReportText;  // script of every page
extern const char* const kPlayerText;  // script of the player

}  // namespace report
