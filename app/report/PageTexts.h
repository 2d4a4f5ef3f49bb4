#pragma once

/// Texts of resources/report, put into the program by the build.
namespace report {

extern const char* const pageText;    // the skeleton, holes as {{name}}
extern const char* const styleText;   // CSS
extern const char* const reportText;  // script of every page
extern const char* const playerText;  // script of the player

}  // namespace report
