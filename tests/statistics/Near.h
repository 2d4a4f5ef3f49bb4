#pragma once

#include <cmath>

#include <QString>

/// Compares with a number of a table or another program; tells both.
#define VERIFY_NEAR(found, wanted, tolerance)               \
  QVERIFY2(std::abs((found) - (wanted)) <= (tolerance),     \
           qPrintable(QStringLiteral("found %1, wanted %2") \
                          .arg(found, 0, 'g', 12)           \
                          .arg(static_cast<double>(wanted), 0, 'g', 12)))
