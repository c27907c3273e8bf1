// SPDX-License-Identifier: GPL-3.0-or-later

#include "someObjects.H"
#include "openfoamCase.H"
#include "randomNumbers.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "../../unit/samples/newShapeTemplate.H"

using namespace Foam;
using Foam::fsi::population;
using Foam::fsi::newShapeTemplate;
using Foam::fsi::shapeTemplate;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Add a shape made from a text
label addShape(population& objects, const word& name, const std::string& text)
{
    return objects.addShape
    (
        autoPtr<shapeTemplate>
        (
            newShapeTemplate
            (
                name, someObjects::dict(text), 0.4, 1, 2
            ).release()
        ),
        someObjects::dict("type free;")
    );
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

autoPtr<Time> someObjects::makeTime
(
    const fsi::boxMesh& box,
    const word& writeFormat
)
{
    const Time& other = const_cast<fsi::boxMesh&>(box).time();
    dictionary controls(other.controlDict());
    controls.set("writeFormat", writeFormat);
    return fsi::newTime(controls, other.rootPath(), other.caseName());
}


dictionary someObjects::dict(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


autoPtr<population> someObjects::make(const Time& time)
{
    autoPtr<population> objects(new population(time, 2, 0.5));

    const label disc = addShape
    (
        *objects,
        "disc",
        "shape { type circle; radius 1; } material { density 2; E 10; }"
    );
    const label ellipse = addShape
    (
        *objects,
        "ellipse",
        "shape { type ellipse; semiAxes (1.5 0.8); }"
        "material { density 3; E 5; springLaw { type Maxwell; viscosity 1; } }"
    );

    const tensor quarterTurn(0, -1, 0, 1, 0, 0, 0, 0, 1);
    objects->append
    (
        labelList({disc, disc, disc, ellipse}),
        pointField({{2, 2, 0}, {5, 2, 0}, {8, 2, 0}, {2, 6, 0}}),
        tensorField(4, tensor::I),
        vectorField(4, vector(1, 0, 0)),
        vectorField(4, vector(0, 0, 0.5))
    );
    objects->append
    (
        ellipse, point(6, 6, 0), quarterTurn, vector(0, 2, 0), vector::zero
    );
    return objects;
}


void someObjects::deform(population& objects)
{
    fsi::randomNumbers random(3);
    const scalar dt = 0.01;
    forAll(objects.groups(), groupi)
    {
        fsi::bodyGroup& group = objects.groups()[groupi];
        Eigen::MatrixXd v(group.velocities());
        for (Eigen::Index i = 0; i < v.size(); ++i)
        {
            v.data()[i] += random.sample01<scalar>() - 0.5;
        }
        group.move(dt, v);
        group.move(dt, v);
    }
    objects.updateSurfaces();
}


bool someObjects::same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols()
        && std::memcmp(a.data(), b.data(), a.size()*sizeof(double)) == 0;
}


// ************************************************************************* //
