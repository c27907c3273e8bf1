// SPDX-License-Identifier: GPL-3.0-or-later

#include "boxMesh.H"
#include "openfoamCase.H"
#include "openfoamMesh.H"
#include "OSspecific.H"
#include "OFstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::boxMesh::cell(const labelVector& ijk) const
{
    return ijk.x() + n_.x()*(ijk.y() + n_.y()*ijk.z());
}


Foam::label Foam::fsi::boxMesh::node(const labelVector& ijk) const
{
    return ijk.x() + (n_.x() + 1)*(ijk.y() + (n_.y() + 1)*ijk.z());
}


Foam::face Foam::fsi::boxMesh::cellFace
(
    const labelVector& ijk,
    const direction dir,
    const int side
) const
{
    labelVector first(ijk);
    first[dir] += side;

    // Around the axis by the right-hand rule
    labelVector a(labelVector::zero);
    labelVector b(labelVector::zero);
    a[(dir + 1) % 3] = 1;
    b[(dir + 2) % 3] = 1;
    if (side == 0)
    {
        Swap(a, b);
    }

    face f(4);
    f[0] = node(first);
    f[1] = node(first + a);
    f[2] = node(first + a + b);
    f[3] = node(first + b);
    return f;
}


Foam::pointField Foam::fsi::boxMesh::nodes() const
{
    const labelVector last(n_ + labelVector::one);
    pointField points(last.x()*last.y()*last.z());

    labelVector ijk;
    for (ijk.z() = 0; ijk.z() < last.z(); ++ijk.z())
    {
        for (ijk.y() = 0; ijk.y() < last.y(); ++ijk.y())
        {
            for (ijk.x() = 0; ijk.x() < last.x(); ++ijk.x())
            {
                const labelVector all(start_ + ijk);
                points[node(ijk)] =
                    layout_.origin
                  + layout_.spacing*vector(all.x(), all.y(), all.z());
            }
        }
    }
    return points;
}


void Foam::fsi::boxMesh::addInternalFaces
(
    DynamicList<face>& faces,
    DynamicList<label>& owner,
    DynamicList<label>& neighbour
) const
{
    labelVector ijk;
    for (ijk.z() = 0; ijk.z() < n_.z(); ++ijk.z())
    {
        for (ijk.y() = 0; ijk.y() < n_.y(); ++ijk.y())
        {
            for (ijk.x() = 0; ijk.x() < n_.x(); ++ijk.x())
            {
                for (direction dir = 0; dir < 3; ++dir)
                {
                    labelVector next(ijk);
                    if (++next[dir] < n_[dir])
                    {
                        faces.append(cellFace(ijk, dir, 1));
                        owner.append(cell(ijk));
                        neighbour.append(cell(next));
                    }
                }
            }
        }
    }
}


Foam::fileName Foam::fsi::boxMesh::makeCase() const
{
    fileName path;
    if (Pstream::master())
    {
        static label nCases = 0;
        path =
            fileName(env("TMPDIR") ? getEnv("TMPDIR") : "/tmp")
           /"fsiMeshTests-" + name(pid()) + '-' + name(nCases++);

        mkDir(path/"system");
        OFstream schemes(path/"system"/"fvSchemes");
        schemes
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object fvSchemes; }\n"
            << "ddtSchemes { default Euler; }\n"
            << "gradSchemes { default Gauss linear; }\n"
            << "divSchemes { default Gauss linear; }\n"
            << "laplacianSchemes { default Gauss linear orthogonal; }\n"
            << "interpolationSchemes { default linear; }\n"
            << "snGradSchemes { default orthogonal; }\n";
        OFstream solution(path/"system"/"fvSolution");
        solution
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object fvSolution; }\n"
            << "solvers\n{\n"
            << "    \"p.*\" { solver PCG; preconditioner DIC;"
            << " tolerance 1e-12; relTol 0; }\n"
            << "    \"U.*\" { solver PBiCGStab; preconditioner DILU;"
            << " tolerance 1e-12; relTol 0; }\n}\n"
            << fsi::stepControlsName()
            << " { nCorrectors 2; nNonOrthogonalCorrectors 0;"
            << " pRefCell 0; pRefValue 0; }\n";
    }
    Pstream::scatter(path);
    return path;
}


void Foam::fsi::boxMesh::makeTime()
{
    dictionary controls;
    controls.add("application", word("fsiMeshTests"));
    controls.add("startFrom", word("startTime"));
    controls.add("startTime", scalar(0));
    controls.add("stopAt", word("endTime"));
    controls.add("endTime", layout_.endTime);
    controls.add("deltaT", layout_.deltaT);
    controls.add("writeControl", word("timeStep"));
    controls.add("writeInterval", labelMax);
    controls.add("writeFormat", word("ascii"));
    controls.add("writePrecision", label(16));
    controls.add("runTimeModifiable", word("no"));

    fileName caseName(casePath_.name());
    if (Pstream::parRun())
    {
        caseName = caseName/("processor" + name(Pstream::myProcNo()));
    }
    mkDir(casePath_.path()/caseName);

    time_ = newTime(controls, casePath_.path(), caseName);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::boxMesh::boxMesh
(
    const labelVector& n,
    const direction nDims,
    const boxLayout& layout
)
:
    nAll_(n),
    nDims_(nDims),
    layout_(layout),
    n_(n),
    start_(labelVector::zero),
    casePath_(makeCase())
{
    const direction split = layout_.splitDirection;
    if (n[split] < Pstream::nProcs())
    {
        FatalErrorInFunction
            << n[split] << " cells cannot be shared by "
            << Pstream::nProcs() << " ranks" << exit(FatalError);
    }
    const label me = Pstream::myProcNo();
    start_[split] = me*n[split]/Pstream::nProcs();
    n_[split] = (me + 1)*n[split]/Pstream::nProcs() - start_[split];

    makeTime();
    makeMesh();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::fsi::boxMesh::~boxMesh()
{
    mesh_.clear();
    time_.clear();

    // No rank may still write when the folder goes
    label ready = 1;
    reduce(ready, sumOp<label>());
    if (Pstream::master())
    {
        rmDir(casePath_);
    }
}


// ************************************************************************* //
