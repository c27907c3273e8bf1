// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Library
    countMessages

Description
    Counts for each rank and time step of an OpenFOAM program: processor time
    outside and inside of MPI, messages, bytes, the largest ones, and the
    largest resident size so far.

    Loaded before all others (LD_PRELOAD), it stands between the program and
    MPI, whose functions can be reached by a second name (PMPI_...), and
    between the solver and Foam::Time::operator++, where a step begins. A rank
    writes the file $FSI_COUNTS/<rank>.csv when it ends. See countMessages.py.

    MPI is Open MPI, whose headers are not needed.

\*---------------------------------------------------------------------------*/

#include "messageCounts.H"
#include "openMPI.H"

#include <dlfcn.h>

namespace
{

record all;


//- Time inside of MPI, for as long as this exists
class inside
{
    const double start_ = processorTime();

public:

    ~inside()
    {
        all.steps.back().inside += processorTime() - start_;
    }
};


long sizeOf(const long n, MPI_Datatype type)
{
    int size = 0;
    PMPI_Type_size(type, &size);
    return n*size;
}


void countMessage(const int n, MPI_Datatype type, const int partner)
{
    all.steps.back().messages.count(sizeOf(n, type));
    all.steps.back().partners.insert(partner);
}


void countCollective(const long n, MPI_Datatype type)
{
    all.steps.back().collectives.count(sizeOf(n, type));
}


//- Values that a rank sends to all
long sum(const int* counts, MPI_Comm comm)
{
    int size = 0;
    long n = 0;
    PMPI_Comm_size(comm, &size);
    for (int i = 0; i < size; ++i)
    {
        n += counts[i];
    }
    return n;
}

} // End namespace


extern "C"
{

//- Foam::Time::operator++()
void* _ZN4Foam4TimeppEv(void* time)
{
    static const auto next =
        reinterpret_cast<void* (*)(void*)>
        (
            dlsym(RTLD_NEXT, "_ZN4Foam4TimeppEv")
        );
    all.steps.back().end();
    all.steps.push_back(counts());
    return next(time);
}


#define SEND(NAME)                                                             \
int MPI_##NAME                                                                 \
(                                                                              \
    const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm \
)                                                                              \
{                                                                              \
    const inside mpi;                                                          \
    countMessage(n, type, to);                                                 \
    return PMPI_##NAME(data, n, type, to, tag, comm);                          \
}

SEND(Send)
SEND(Bsend)


int MPI_Isend
(
    const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm,
    MPI_Request* request
)
{
    const inside mpi;
    countMessage(n, type, to);
    return PMPI_Isend(data, n, type, to, tag, comm, request);
}


int MPI_Recv
(
    void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm,
    MPI_Status* status
)
{
    const inside mpi;
    return PMPI_Recv(data, n, type, from, tag, comm, status);
}


int MPI_Irecv
(
    void* data, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm,
    MPI_Request* request
)
{
    const inside mpi;
    return PMPI_Irecv(data, n, type, from, tag, comm, request);
}


int MPI_Probe(int from, int tag, MPI_Comm comm, MPI_Status* status)
{
    const inside mpi;
    return PMPI_Probe(from, tag, comm, status);
}


int MPI_Wait(MPI_Request* request, MPI_Status* status)
{
    const inside mpi;
    return PMPI_Wait(request, status);
}


int MPI_Waitall(int n, MPI_Request requests[], MPI_Status statuses[])
{
    const inside mpi;
    return PMPI_Waitall(n, requests, statuses);
}


int MPI_Test(MPI_Request* request, int* done, MPI_Status* status)
{
    const inside mpi;
    return PMPI_Test(request, done, status);
}


int MPI_Allreduce
(
    const void* data, void* result, int n, MPI_Datatype type, MPI_Op operation,
    MPI_Comm comm
)
{
    const inside mpi;
    countCollective(n, type);
    return PMPI_Allreduce(data, result, n, type, operation, comm);
}


int MPI_Iallreduce
(
    const void* data, void* result, int n, MPI_Datatype type, MPI_Op operation,
    MPI_Comm comm, MPI_Request* request
)
{
    const inside mpi;
    countCollective(n, type);
    return PMPI_Iallreduce(data, result, n, type, operation, comm, request);
}


int MPI_Bcast(void* data, int n, MPI_Datatype type, int from, MPI_Comm comm)
{
    const inside mpi;
    countCollective(n, type);
    return PMPI_Bcast(data, n, type, from, comm);
}


#define EXCHANGE(NAME)                                                         \
int MPI_##NAME                                                                 \
(                                                                              \
    const void* data, int n, MPI_Datatype type,                                \
    void* result, int m, MPI_Datatype other, MPI_Comm comm                     \
)                                                                              \
{                                                                              \
    const inside mpi;                                                          \
    int size = 0;                                                              \
    PMPI_Comm_size(comm, &size);                                               \
    countCollective(long(n)*size, type);                                       \
    return PMPI_##NAME(data, n, type, result, m, other, comm);                 \
}

EXCHANGE(Alltoall)
EXCHANGE(Allgather)


int MPI_Alltoallv
(
    const void* data, const int counts[], const int places[],
    MPI_Datatype type, void* result, const int resultCounts[],
    const int resultPlaces[], MPI_Datatype resultType, MPI_Comm comm
)
{
    const inside mpi;
    countCollective(sum(counts, comm), type);
    return PMPI_Alltoallv
    (
        data, counts, places, type, result, resultCounts, resultPlaces,
        resultType, comm
    );
}


int MPI_Gatherv
(
    const void* data, int n, MPI_Datatype type, void* result,
    const int counts[], const int places[], MPI_Datatype resultType, int root,
    MPI_Comm comm
)
{
    const inside mpi;
    countCollective(n, type);
    return PMPI_Gatherv
    (
        data, n, type, result, counts, places, resultType, root, comm
    );
}


int MPI_Scatterv
(
    const void* data, const int counts[], const int places[],
    MPI_Datatype type, void* result, int n, MPI_Datatype resultType, int root,
    MPI_Comm comm
)
{
    const inside mpi;
    int rank = 0;
    PMPI_Comm_rank(comm, &rank);
    countCollective(rank == root ? sum(counts, comm) : 0, type);
    return PMPI_Scatterv
    (
        data, counts, places, type, result, n, resultType, root, comm
    );
}

} // End extern "C"


// ************************************************************************* //
