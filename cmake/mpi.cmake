# changeover_use_mpi(<target>): lets mpirun start several processes of one job, if MPI is there when
# this is configured. Defines CHANGEOVER_WITH_MPI; without MPI the target is alone. With LATE as
# second argument, Open MPI is loaded late.
option(CHANGEOVER_MPI "Let mpirun start several processes of one job" ON)

if(CHANGEOVER_MPI)
  changeover_try_optional(CHANGEOVER_HAS_MPI MPI "
    find_package(MPI REQUIRED COMPONENTS CXX)
    add_executable(tried tried.cpp)
    target_link_libraries(tried PRIVATE MPI::MPI_CXX)
    target_compile_definitions(tried PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)" "
    #include <mpi.h>
    int main(int count, char** arguments) {
      MPI_Init(&count, &arguments);
      return MPI_Finalize();
    }")
  if(CHANGEOVER_HAS_MPI)
    find_package(MPI QUIET COMPONENTS CXX) # once, here: it takes a second, and targets below see it
  endif()
endif()

function(changeover_use_mpi target)
  if(CHANGEOVER_MPI AND CHANGEOVER_HAS_MPI AND MPI_CXX_FOUND)
    set(library ${MPI_CXX_LIBRARIES})
    list(FILTER library INCLUDE REGEX "/libmpi[.]so$")
    if(ARGN AND library)
      changeover_late(${target} CHANGEOVER_LATE_MPI MPI::MPI_CXX "${library}")
    else()
      target_link_libraries(${target} PRIVATE MPI::MPI_CXX)
    endif()
    # Without the C++ bindings, which MPI has dropped.
    target_compile_definitions(${target} PRIVATE
      CHANGEOVER_WITH_MPI OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  endif()
endfunction()
