# The Debian packages: `cpack --config build/release/CPackConfig.cmake`; with the preset `python` also that of
# the Python module, and with OpenCV that of the module of the planner `onnx`. Their dependencies are read from
# the program and the modules (dpkg-shlibdeps), so a package fits the system on which it was built. With
# SOURCE_DATE_EPOCH set, equal sources give equal bytes.
set(HUNAV_MAINTAINER "HuNavSim Desktop developers <noreply@localhost>" CACHE STRING
    "Maintainer in the package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hunavsim)
set(CPACK_PACKAGE_VENDOR "HuNavSim Desktop developers")
set(CPACK_PACKAGE_CONTACT "${HUNAV_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Simulate and evaluate robots among people")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Draw a scenario on a map, populate it with people driven by behaviour trees and
social forces, drive a robot among them, and measure its performance. Reads and
writes the files of HuNavSim 2.0 and needs no ROS.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, shared-mime-info, qttranslations5-l10n")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk")  # or any font with Chinese characters
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
if(HUNAV_PYTHON OR HUNAV_ONNX)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME ${CPACK_PACKAGE_NAME})
  set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "${CPACK_DEBIAN_PACKAGE_DESCRIPTION}")
endif()
if(HUNAV_ONNX)  # a package of its own: the program itself does not depend on OpenCV
  set(CPACK_DEBIAN_ONNX_PACKAGE_NAME hunavsim-onnx)
  set(CPACK_DEBIAN_ONNX_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_ONNX_PACKAGE_DEPENDS "hunavsim (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_ONNX_PACKAGE_RECOMMENDS "")
  set(CPACK_DEBIAN_ONNX_PACKAGE_SUGGESTS "")
  set(CPACK_COMPONENT_ONNX_DESCRIPTION
"Learned planners of HuNavSim Desktop: the planner onnx runs policies in ONNX
files on OpenCV.")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", hunavsim-onnx (= ${PROJECT_VERSION})")
endif()
if(HUNAV_PYTHON)  # a package of its own, which needs the data of the other one
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-hunavsim)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "hunavsim (= ${PROJECT_VERSION}), python3-numpy, \
python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"Python module of HuNavSim Desktop: edit and run scenarios, traces as numpy
arrays, metrics, studies, and environments for reinforcement learning.")
endif()
include(CPack)
