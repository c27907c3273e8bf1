// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneSlip.H"
#include "membraneLanes.H"

#include <Eigen/Geometry>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Area times normal of a triangle, or of a segment of some depth
template<class Positions>
static Eigen::Vector3d areaVector
(
    const Positions& x,
    const surfaceFace& f,
    const scalar depth
)
{
    const Eigen::Vector3d side(inSpace(x.row(f[1]) - x.row(f[0])));
    return
        f[2] < 0
      ? Eigen::Vector3d(depth*side.cross(Eigen::Vector3d::UnitZ()))
      : Eigen::Vector3d(0.5*side.cross(inSpace(x.row(f[2]) - x.row(f[0]))));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneSlip::setAreas
(
    const Eigen::Ref<const Eigen::MatrixXd>& positions,
    Eigen::ArrayXd& areas,
    Eigen::MatrixXd& normals
) const
{
    areas.setZero(positions.rows());
    normals.setZero(positions.rows(), nDims_);
    for (const surfaceFace& f : mesh_.faces)
    {
        const Eigen::Vector3d area
        (
            areaVector(positions, f, depth_)/nDims_
        );
        const scalar size = area.norm();
        for (label k = 0; k < nDims_; ++k)
        {
            areas[f[k]] += size;
            for (label d = 0; d < nDims_; ++d)
            {
                normals(f[k], d) += area[d];
            }
        }
    }
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
    const Eigen::MatrixXd x(rowsOf(mesh.points));
    std::vector<Eigen::Triplet<double>> weights;
    Eigen::ArrayXd total(Eigen::ArrayXd::Zero(mesh.points.size()));
    for (const surfaceFace& f : mesh.faces)
    {
        const scalar area = areaVector(x, f, depth).norm();
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
    Eigen::ArrayXd areas;
    Eigen::MatrixXd normals;
    setAreas(positions, areas, normals);
    const Eigen::ArrayXd sizes(normals.rowwise().squaredNorm().array());
    const auto alongSheet = [&](Eigen::MatrixXd& values)
    {
        const Eigen::ArrayXd across
        (
            (values.array()*normals.array()).rowwise().sum()
           /sizes.max(VSMALL)
        );
        values.array() -= normals.array().colwise()*across;
    };

    Eigen::MatrixXd perArea
    (
        force.array().colwise()/areas.max(VSMALL)
    );
    alongSheet(perArea);
    for (label i = 0; i < passes; ++i)
    {
        perArea = (mean_*perArea).eval();
    }
    alongSheet(perArea);
    const scalar inner = material_.innerViscosity;
    const scalar perViscosity =
        0.5*(1/step.viscosity + 1/(inner > 0 ? inner : step.viscosity));
    velocity += step.lag*step.spacing*perViscosity*perArea;
}


// ************************************************************************* //
