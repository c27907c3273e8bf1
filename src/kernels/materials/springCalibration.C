// SPDX-License-Identifier: GPL-3.0-or-later

#include "springCalibration.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "openfoamVersion.H"
#include "patchTest.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace springCalibration
{

//- Elements of about the size at the boundary, and larger ones if they are
//  more than a twentieth of the body
static labelListList regions
(
    const shapeMesh& mesh,
    const scalarField& volumes,
    const scalar thickness
)
{
    scalar side = 0;
    for (const surfaceFace& face : mesh.faces)
    {
        side += mag(mesh.points[face[1]] - mesh.points[face[0]]);
    }
    side /= mesh.faces.size();
    const scalar equilateral = 0.25*std::sqrt(3.0)*sqr(side)*thickness;

    labelListList result(2);
    scalar volume = 0;
    forAll(volumes, elementi)
    {
        const bool large = volumes[elementi] > 1.5*equilateral;
        result[large].append(elementi);
        volume += large ? volumes[elementi] : 0;
    }
    if (volume <= 0.05*sum(volumes))
    {
        result = labelListList(1, identityList(volumes.size()));
    }
    return result;
}


//- Region of each spring: the first that has an element at it
static labelList regionsOfSprings
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const labelListList& regions
)
{
    EdgeMap<label> regionOf(2*springs.size());
    forAllReverse(regions, regioni)
    {
        for (const label elementi : regions[regioni])
        {
            const bodyElement& e = mesh.elements[elementi];
            for (label i = 0; i < 3; ++i)
            {
                regionOf.set(edge(e[i], e[(i + 1) % 3]), regioni);
            }
        }
    }
    labelList result(springs.size());
    forAll(springs, springi)
    {
        result[springi] = regionOf[springs[springi]];
    }
    return result;
}


//- 1/E of a stretch at an angle in the plane [1/Pa]
static scalar modulusInverse(const Eigen::MatrixXd& S, const scalar angle)
{
    return patchTest::modulusInverse
    (
        S, vector(std::cos(angle), std::sin(angle), 0)
    );
}


//- 2D: correct the constants [N/m] until E is shown in all directions
static void calibratePlanar
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const volumeTerm& elementTerm,
    const scalar thickness,
    const scalar youngsModulus,
    scalarField& constants
)
{
    const scalar pi = constant::mathematical::pi;
    const scalar factor =
        regularFactor(youngsModulus, elementTerm.stiffness(), 2);

    // Poisson's ratio from 2 mu (1 + nu) = E, and the gains of the harmonics
    const scalar nu = 4/(3*factor) - 1;
    const scalar gain0 = sqr(1 - nu) + 0.5*sqr(1 + nu);
    const scalar gain2 = min(gain0/max(1 - sqr(nu), SMALL), scalar(4));
    const scalar gain4 = 4*gain0/sqr(1 + nu);

    const labelListList parts(regions(mesh, elementTerm.volumes(), thickness));
    const labelList partOf(regionsOfSprings(mesh, springs, parts));
    for (label iteration = 0; iteration < 30; ++iteration)
    {
        const auto compliances = patchTest::compliances
        (
            mesh, springs, constants, elementTerm, thickness, parts
        );

        scalar largest = 0;
        forAll(springs, springi)
        {
            const Eigen::MatrixXd& S = compliances[partOf[springi]];
            const vector d = springs[springi].vec(mesh.points);
            const scalar angle = std::atan2(d.y(), d.x());
            const scalar at0 = modulusInverse(S, angle);
            const scalar at45 = modulusInverse(S, angle + 0.25*pi);
            const scalar at90 = modulusInverse(S, angle + 0.5*pi);
            const scalar at135 = modulusInverse(S, angle - 0.25*pi);

            // Harmonics 0, 2 and 4 of E/E(angle)
            const scalar mean =
                0.25*youngsModulus*(at0 + at45 + at90 + at135);
            const scalar second = 0.5*youngsModulus*(at0 - at90);
            const scalar fourth = youngsModulus*at0 - mean - second;
            const scalar correction = mean - 1 + gain2*second + gain4*fourth;
            constants[springi] *= 1 + correction;
            largest = max(largest, mag(correction));
        }
        if (largest < 1e-8)
        {
            break;
        }
    }
}


//- 3D: correct the constants [N/m] until E is shown within the tolerance
static void calibrateSpatial
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const volumeTerm& elementTerm,
    const scalar youngsModulus,
    const label nIterations,
    const scalar tolerance,
    scalarField& constants
)
{
    const labelListList whole(1, identityList(mesh.elements.size()));
    for (label iteration = 0; iteration < nIterations; ++iteration)
    {
        const Eigen::MatrixXd S = patchTest::compliances
        (
            mesh, springs, constants, elementTerm, 1, whole
        )[0];

        scalar largest = 0;
        forAll(springs, springi)
        {
            const vector d = springs[springi].vec(mesh.points);
            const scalar ratio =
                youngsModulus*patchTest::modulusInverse(S, d/mag(d));
            constants[springi] *= ratio;
            largest = max(largest, mag(ratio - 1));
        }
        if (largest < tolerance)
        {
            break;
        }
    }
}


//- 3D: springs alone, whose matrix is the cheaper one, then with volume terms
static void calibrateSpatial
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const volumeTerm& elementTerm,
    const scalar youngsModulus,
    scalarField& constants
)
{
    const auto element = strainDomains::kind::element;
    const volumeTerm none(mesh, 1, 0, 0, element, element);
    calibrateSpatial(mesh, springs, none, youngsModulus, 10, 1e-3, constants);
    if (elementTerm.stiffness() > 0)
    {
        constants *= regularFactor(youngsModulus, elementTerm.stiffness(), 3);
        calibrateSpatial
        (
            mesh, springs, elementTerm, youngsModulus, 4, 5e-3, constants
        );
    }
}

} // End namespace springCalibration
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::springCalibration::vanGelder
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const scalarField& volumes
)
{
    EdgeMap<label> springOf(2*springs.size());
    forAll(springs, springi)
    {
        springOf.insert(springs[springi], springi);
    }

    scalarField constants(springs.size(), Zero);
    forAll(mesh.elements, elementi)
    {
        const bodyElement& element = mesh.elements[elementi];
        for (label i = 0; i < mesh.nDims() + 1; ++i)
        {
            for (label j = 0; j < i; ++j)
            {
                const edge side(element[i], element[j]);
                constants[springOf[side]] += volumes[elementi];
            }
        }
    }
    forAll(springs, springi)
    {
        constants[springi] /= sqr(springs[springi].mag(mesh.points));
    }
    return constants;
}


Foam::scalar Foam::fsi::springCalibration::regularFactor
(
    const scalar youngsModulus,
    const scalar areaStiffness,
    const label nDims
)
{
    const scalar kappa = areaStiffness/youngsModulus;
    if (nDims == 3)
    {
        const scalar b = 3*kappa - 4;
        const scalar mu = (std::sqrt(b*b + 40*kappa) - b)/20;
        return 5*mu/2;
    }
    const scalar b = 2*kappa - 3;
    const scalar mu = (std::sqrt(b*b + 16*kappa) - b)/16;
    return 8*mu/3;
}


Foam::scalarField Foam::fsi::springCalibration::calibrated
(
    const shapeMesh& mesh,
    const edgeList& springs,
    const volumeTerm& elementTerm,
    const scalar thickness,
    const scalar youngsModulus
)
{
    scalarField constants(vanGelder(mesh, springs, elementTerm.volumes()));
    if (mesh.nDims() == 3)
    {
        constants *= youngsModulus;
        calibrateSpatial
        (
            mesh, springs, elementTerm, youngsModulus, constants
        );
        return constants;
    }
    constants *=
        regularFactor(youngsModulus, elementTerm.stiffness(), 2)
       *youngsModulus;
    calibratePlanar
    (
        mesh, springs, elementTerm, thickness, youngsModulus, constants
    );
    return constants;
}


// ************************************************************************* //
