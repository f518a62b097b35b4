# Fails when a rule or a public case has no test in tests/extremes, by the tags of TEST_CASEs there; and when a
# case that still waits for its technique has got one, so that the list below stays true.
#   cmake -D ROOT=<folder of the project> -P tests/extremes/cases.cmake

cmake_minimum_required(VERSION 3.25)

set(rules R1 R2 R3 R4 R5 R6 C1 C2 C3 C4 C5 C6 C7 P1 P2 P3 P4 P5 Z1 Z2 Z3 T1 T2 T3 T4 T5 T6 B1 B2 S1 S2 S3)
set(cases 73 74)
foreach(number RANGE 1 57)
  string(LENGTH "${number}" digits)
  if(digits EQUAL 1)
    list(APPEND cases 0${number})
  else()
    list(APPEND cases ${number})
  endif()
endforeach()

# What the machine cannot do yet: nothing of these. The tracer's half of case 57 (a mirrored frame against reflected
# rays) is in tests/tracer_witness; the furnaces of rule S3 wait for the tracer's reflection models.
set(waiting)

file(GLOB files ${ROOT}/tests/extremes/*_test.cpp)
set(tags "")
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "^TEST_CASE\\(")
  foreach(line IN LISTS lines)
    # CMake's lists may not hold brackets: the tags become words.
    string(REGEX MATCHALL "\\[[A-Za-z0-9-]+\\]" found "${line}")
    string(REGEX REPLACE "[][]" " " found "${found}")
    string(APPEND tags " ${found} ")
  endforeach()
endforeach()

set(missing "")
set(present 0)
foreach(name IN LISTS rules cases)
  if(name IN_LIST cases)
    set(tag case-${name})
  else()
    set(tag ${name})
  endif()
  if(tags MATCHES "[ ;]${tag}[ ;]")
    math(EXPR present "${present} + 1")
    if(name IN_LIST waiting)
      message(FATAL_ERROR "case ${name} has a test now: take it off the list of those that wait")
    endif()
  elseif(NOT name IN_LIST waiting)
    list(APPEND missing ${tag})
  endif()
endforeach()

if(missing)
  list(JOIN missing ", " missing)
  message(FATAL_ERROR "no test in tests/extremes has these tags: ${missing}")
endif()
list(LENGTH waiting count)
message("${present} rules and cases have tests, ${count} cases wait for their technique")
