// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepRecord.H"
#include "csvTable.H"
#include "population.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Largest speed of a node of a group [m/s]
static scalar maxSpeed(const bodyGroup& group, const direction nDims)
{
    const Eigen::MatrixXd& v = group.velocities();
    scalar largest = 0;
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        largest = max
        (
            largest,
            v.middleCols(nDims*copyi, nDims).rowwise().squaredNorm().maxCoeff()
        );
    }
    return sqrt(largest);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsi::stepRecord Foam::fsi::stepRecord::sample(const population& objects)
{
    stepRecord record;
    record.objects = objects.nAll();
    scalar sumVolume = 0;
    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        record.maxSpeed =
            max(record.maxSpeed, fsi::maxSpeed(group, objects.nDims()));
        record.kineticEnergy += group.kineticEnergy();
        record.elasticEnergy += group.elasticEnergy();
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            const scalar volume = group.volume(copyi);
            if (group.movesFreely())
            {
                sumVolume += volume;
                record.objectVelocity += volume*group.velocity(copyi);
            }
            record.areaChange = max
            (
                record.areaChange,
                mag(volume/group.shape().referenceVolume() - 1)
            );
        }
    }
    scalarField sums
    (
        scalarList
        ({
            record.kineticEnergy, record.elasticEnergy, sumVolume,
            record.objectVelocity.x(), record.objectVelocity.y(),
            record.objectVelocity.z()
        })
    );
    const objectRanks& ranks = objects.ranks();
    ranks.sum(sums);
    record.kineticEnergy = sums[0];
    record.elasticEnergy = sums[1];
    record.objectVelocity =
        vector(sums[3], sums[4], sums[5])/max(sums[2], VSMALL);
    record.maxSpeed = ranks.largest(record.maxSpeed);
    record.areaChange = ranks.largest(record.areaChange);
    return record;
}


Foam::wordList Foam::fsi::stepRecord::columns()
{
    return wordList
    ({
        "time", "deltaT", "objects", "contacts", "smallestGap",
        "kineticEnergy", "elasticEnergy", "contactEnergy", "areaChange",
        "misfit", "rebuilds", "fluidSeconds", "pressureSeconds",
        "levelSetSeconds", "solidsSeconds", "contactSeconds", "couplingSeconds",
        "removed", "fed", "maxSpeed",
        "fluidVelocityX", "fluidVelocityY", "fluidVelocityZ",
        "objectVelocityX", "objectVelocityY", "objectVelocityZ",
        "timeError",
        "drivingAccelerationX", "drivingAccelerationY", "drivingAccelerationZ"
    });
}


void Foam::fsi::stepRecord::write(csvTable& table) const
{
    csvTable::rowWriter row(table);
    row << time << deltaT << objects << contacts << smallestGap
        << kineticEnergy << elasticEnergy << contactEnergy << areaChange
        << misfit << rebuilds;
    for (const scalar s : seconds)
    {
        row << s;
    }
    row << removed << fed << maxSpeed << fluidVelocity << objectVelocity
        << timeError << drivingAcceleration;
}


void Foam::fsi::stepRecord::log(Ostream& os, const stepTimer& timer) const
{
    os  << "Objects: " << objects;
    if (removed + fed > 0)
    {
        os  << ", removed " << removed << ", fed " << fed;
    }
    os  << ", contacts " << contacts;
    if (smallestGap < GREAT)
    {
        os  << ", smallest gap " << smallestGap;
    }
    os  << ", largest speed " << maxSpeed
        << ", kinetic energy " << kineticEnergy
        << ", elastic energy " << elasticEnergy
        << ", contact energy " << contactEnergy
        << ", area change " << areaChange
        << ", misfit/h " << misfit
        << ", rebuilds " << rebuilds
        << ", step " << timer.stepSeconds() << " s"
        << ", remaining " << stepTimer::clockString(timer.remaining()).c_str()
        << nl << "Time error: " << timeError << endl;
}


// ************************************************************************* //
