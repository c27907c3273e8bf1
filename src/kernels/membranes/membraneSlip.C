// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneSlip.H"
#include "membraneLanes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Area times normal of a triangle, or of a segment of some depth
static vector areaVector
(
    const UList<vector>& x,
    const surfaceFace& f,
    const scalar depth
)
{
    const vector side(x[f[1]] - x[f[0]]);
    return
        f[2] < 0
      ? vector(depth*side.y(), -depth*side.x(), 0)
      : 0.5*(side^(x[f[2]] - x[f[0]]));
}


//- Take away the part across the sheet
static void keepAlong(const vectorField& areas, vectorField& values)
{
    forAll(values, i)
    {
        const vector& n = areas[i];
        values[i] -= ((values[i] & n)/max(magSqr(n), VSMALL))*n;
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneSlip::setAreas
(
    const Eigen::Ref<const Eigen::MatrixXd>& positions,
    vectorField& areas,
    scalarField& sizes
) const
{
    const vectorField x(vectorsOf(positions));
    areas.setSize(x.size());
    areas = Zero;
    sizes.setSize(x.size());
    sizes = 0;
    for (const surfaceFace& f : mesh_.faces)
    {
        const vector share(areaVector(x, f, depth_)/nDims_);
        const scalar size = mag(share);
        for (label k = 0; k < nDims_; ++k)
        {
            areas[f[k]] += share;
            sizes[f[k]] += size;
        }
    }
}


void Foam::fsi::membraneSlip::smooth
(
    vectorField& values,
    vectorField& work
) const
{
    const int* start = mean_.outerIndexPtr();
    const int* node = mean_.innerIndexPtr();
    const double* weight = mean_.valuePtr();
    work.setSize(values.size());
    forAll(work, i)
    {
        vector mean(Zero);
        for (int k = start[i]; k < start[i + 1]; ++k)
        {
            mean += weight[k]*values[node[k]];
        }
        work[i] = mean;
    }
    values.swap(work);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneSlip::membraneSlip
(
    const sheetMaterial& material,
    const shapeMesh& mesh,
    const scalar spacing,
    const scalar depth
)
:
    material_(material),
    mesh_(mesh),
    spacing_(spacing),
    depth_(depth),
    nDims_(mesh.faces[0][2] < 0 ? 2 : 3),
    mean_(mesh.points.size(), mesh.points.size())
{
    std::vector<Eigen::Triplet<double>> weights;
    Eigen::ArrayXd total(Eigen::ArrayXd::Zero(mesh.points.size()));
    for (const surfaceFace& f : mesh.faces)
    {
        const scalar area = mag(areaVector(mesh.points, f, depth));
        for (label k = 0; k < nDims_; ++k)
        {
            total[f[k]] += nDims_*area;
            for (label j = 0; j < nDims_; ++j)
            {
                weights.emplace_back(f[k], f[j], area);
            }
        }
    }
    mean_.setFromTriplets(weights.begin(), weights.end());
    mean_ = total.max(VSMALL).inverse().matrix().asDiagonal()*mean_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::membraneSlip::passes
(
    const membraneForceStep& step,
    const scalar modulus
) const
{
    // With p passes the wave that grows fastest has the rate
    // 2 d/(e (p + 1)) c a/(mu h) (h/spacing)^2 in d dimensions. As many as the
    // longest explicit step needs, so that the flow does not depend on the step
    const scalar number = max(step.number(modulus), step.mostExplicit);
    const scalar rate =
        0.736*nDims_*step.lag*number
       *sqr(step.spacing/spacing_);
    return label(min(max(rate, scalar(1)), scalar(1000)));
}


void Foam::fsi::membraneSlip::add
(
    const membraneForceStep& step,
    const label passes,
    const Eigen::Ref<const Eigen::MatrixXd>& positions,
    const Eigen::Ref<const Eigen::MatrixXd>& force,
    Eigen::Ref<Eigen::MatrixXd> velocity
) const
{
    vectorField areas;
    scalarField sizes;
    setAreas(positions, areas, sizes);
    vectorField perArea(vectorsOf(force));
    perArea /= max(sizes, VSMALL);
    keepAlong(areas, perArea);
    vectorField work;
    for (label i = 0; i < passes; ++i)
    {
        smooth(perArea, work);
    }
    keepAlong(areas, perArea);
    const scalar inner = material_.innerViscosity;
    const scalar perViscosity =
        0.5*(1/step.viscosity + 1/(inner > 0 ? inner : step.viscosity));
    perArea *= step.lag*step.spacing*perViscosity;
    velocity += rowsOf(perArea).leftCols(nDims_);
}


// ************************************************************************* //
